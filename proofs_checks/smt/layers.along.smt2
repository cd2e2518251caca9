; layers.along: gaps of the Tube
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(assert (>= (+ (* 1.0 W) (- (/ 599.0 5000.0))) 0.0))
(assert (> (+ (* (- 1.0) W) (/ 503.0 5000.0)) 0.0))
(check-sat)
