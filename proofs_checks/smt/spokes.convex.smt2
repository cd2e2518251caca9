; spokes.convex: at a convex corner the angle is obtuse: (-t).d = -k/4
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(assert (>= (* 1.0 k) 0.0))
(assert (> (* (- 1.0) k) 0.0))
(check-sat)
