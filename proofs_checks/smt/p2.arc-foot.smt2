; p2.arc-foot: (y, 1/4) is 1/4 from p only for y = 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const y Real)
(assert (>= (* (- 1.0) y y) 0.0))
(assert (> (* 1.0 y y) 0.0))
(check-sat)
