; slanted.fan-over: v left of A: h or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const h Real)
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 c) (* (- 1.0) h)) 0.0))
(assert (> (+ (* (- 2.0) c) (* 1.0 h) (/ 599.0 5000.0)) 0.0))
(check-sat)
