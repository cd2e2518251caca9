; tilings.row-low: (b, b', a)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const g Real)
(assert (> (* 1.0 g) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (* (- 1.0) d g) 0.0))
(check-sat)
