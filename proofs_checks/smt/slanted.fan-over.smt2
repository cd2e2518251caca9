; slanted.fan-over: v left of A: it is h or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 1.0) h) (/ 1759.0 10000.0)) 0.0))
(check-sat)
