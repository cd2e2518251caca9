; tube.left-turn: L, a', a turn left: D u > 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const u Real)
(declare-const w Real)
(declare-const x2 Real)
(assert (> (* 1.0 u) 0.0))
(assert (> (* 1.0 D) 0.0))
(assert (> (* 1.0 w) 0.0))
(assert (> (+ (* (- 1.0) w) (* 1.0 x2)) 0.0))
(assert (>= (* (- 1.0) D u) 0.0))
(check-sat)
