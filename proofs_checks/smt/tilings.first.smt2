; tilings.first: (0, foot, E_1), and (u, u', E) for a gap u u' and an apex y > 0 above
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const g Real)
(declare-const y Real)
(assert (> (* 1.0 g) 0.0))
(assert (> (* 1.0 y) 0.0))
(assert (>= (* (- 1.0) g y) 0.0))
(check-sat)
