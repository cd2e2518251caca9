; lemma-3.heights-from: 2 x_i <= x_i+1: top_i is 1/3 or more above E_i
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const xi Real)
(declare-const xj Real)
(assert (> (* 1.0 xi) 0.0))
(assert (>= (+ (* (- 2.0) xi) (* 1.0 xj)) 0.0))
(assert (> (+ (* 2.0 xi) (* (- 1.0) xj)) 0.0))
(check-sat)
