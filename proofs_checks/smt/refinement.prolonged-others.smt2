; refinement.prolonged-others: 1 - sqrt(2)/4 > 1/4: edges that do not end in v are farther
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* (- 1.0) q q) 2.0) 0.0))
(assert (>= (+ (* 1.0 q) (- 3.0)) 0.0))
(check-sat)
