; tiles.near: the near corner, a foot d below, the vertex x beside: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const x Real)
(assert (> (* 1.0 x) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (* (- 1.0) d x) 0.0))
(check-sat)
