; tilings.corner: (0, E_1, A)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (> (* 1.0 x) 0.0))
(assert (>= (* (- 1.0) x) 0.0))
(check-sat)
