; tilings.row-ends: (0, u_1, A)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const g Real)
(assert (> (* 1.0 g) 0.0))
(assert (>= (* (- 1.0) g) 0.0))
(check-sat)
