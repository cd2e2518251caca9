; results.interior: the Interior keeps more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const f Real)
(declare-const m Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* 1.0 f) (* (- (/ 29.0 625.0)) m)) 0.0))
(assert (> (+ (* (- 1.0) f) (* (/ 223.0 10000.0) m)) 0.0))
(check-sat)
