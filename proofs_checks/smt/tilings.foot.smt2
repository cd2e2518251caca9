; tilings.foot: (foot, first, top) with E on its side: the first apex or F beyond, top above
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const y Real)
(assert (> (* 1.0 y) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (* (- 1.0) d y) 0.0))
(check-sat)
