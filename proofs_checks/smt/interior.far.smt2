; interior.far: b, not less than the lean r >= 2 H of a leg, beside its end: off its line
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const b Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 2.0) H) (* 1.0 r)) 0.0))
(assert (>= (+ (* 1.0 b) (* (- 1.0) r)) 0.0))
(assert (> (+ (* (- 1.0) H H b b) (* (/ 841.0 250000.0) H H) (* (/ 841.0 250000.0) r r)) 0.0))
(check-sat)
