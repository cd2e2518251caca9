; lemma-3.heights-to: x_i+1 <= 4 x_i: e_i+1 is at most 5/6 high from x_i on
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const xi Real)
(declare-const xj Real)
(assert (> (* 1.0 xi) 0.0))
(assert (>= (+ (* 4.0 xi) (* (- 1.0) xj)) 0.0))
(assert (> (+ (* (- 2.0) xi) (* (/ 1.0 2.0) xj)) 0.0))
(check-sat)
