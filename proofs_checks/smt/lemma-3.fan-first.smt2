; lemma-3.fan-first: E_1 = (1, 1/3) is f1 from e_2, x_2 >= 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const w Real)
(declare-const xj Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (>= (+ (* 1.0 xj) (- 2.0)) 0.0))
(assert (> (+ (* (- 4.0) h h xj xj) (* (- 135.0) w w xj xj) (* 8.0 h h xj) (* 288.0 w w xj) (* (- 144.0) w w)) 0.0))
(check-sat)
