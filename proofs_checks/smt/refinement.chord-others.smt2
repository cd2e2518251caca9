; refinement.chord-others: 3/4 > 1/(4 sqrt 2), as q >= sqrt 2 >= 1: other edges are farther
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* 1.0 q q) (- 2.0)) 0.0))
(assert (>= (+ (* (- 3.0) q) 1.0) 0.0))
(check-sat)
