; refinement.8-d3-tube: 32 sqrt 2 > 45
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* 1.0 q q) (- 2.0)) 0.0))
(assert (>= (+ (* (- 32.0) q) 45.0) 0.0))
(check-sat)
