; caps.k1-out-level-1.ahead: k1, e' out, level, vertex 1 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(assert (>= (* (- (/ 29.0 125.0)) dx) 0.0))
(assert (>= (* (/ 29.0 125.0) dx) 0.0))
(assert (>= (* (- (/ 667.0 2000.0)) dx) 0.0))
(assert (> (* 1.0 dx dx) 0.0))
(check-sat)
