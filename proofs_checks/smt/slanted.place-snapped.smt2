; slanted.place-snapped: so C is beyond A, snapped by g/2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const b Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) x) (/ 4247.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) L) (* 1.0 b) (* 1.0 x) (/ 29.0 250.0)) 0.0))
(assert (>= (* (- 1.0) b) 0.0))
(check-sat)
