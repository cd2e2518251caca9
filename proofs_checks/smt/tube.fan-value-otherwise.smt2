; tube.fan-value-otherwise: with d3 = 4 sqrt 2 it is 1/(8 q^2) = 1/16, less than 0.067
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* 1.0 q q) (- 2.0)) 0.0))
(assert (>= (+ (* (- (/ 67.0 125.0)) q q) 1.0) 0.0))
(check-sat)
