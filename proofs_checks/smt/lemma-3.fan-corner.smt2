; lemma-3.fan-corner: (0,0) is f1 from e_1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const w Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (> (+ (* (- 5.0) h h) (* (- 315.0) w w)) 0.0))
(check-sat)
