; tilings.below: u below e_i+1 by v, with one of its points and another one d before it: (u, q, p)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const v Real)
(assert (> (* 1.0 v) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (* (- 1.0) d v) 0.0))
(check-sat)
