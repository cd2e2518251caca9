; caps.k3-out-level-4.ahead: k3, e' out, level, vertex 4 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(assert (>= (* (/ 29.0 125.0) dx) 0.0))
(assert (>= 0.0 0.0))
(assert (>= (* (/ 3.0 20.0) dx) 0.0))
(assert (> (* 1.0 dx dx) 0.0))
(assert (> (* (- (/ 115479.0 250000.0)) dx dx) 0.0))
(check-sat)
