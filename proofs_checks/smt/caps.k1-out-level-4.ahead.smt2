; caps.k1-out-level-4.ahead: k1, e' out, level, vertex 4 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(assert (>= (* (- (/ 29.0 125.0)) dx) 0.0))
(assert (>= (* (/ 29.0 125.0) dx) 0.0))
(assert (>= (* (- (/ 817.0 1000.0)) dx) 0.0))
(assert (> (* 1.0 dx dx) 0.0))
(check-sat)
