; layers.quad-near.area: two neighbours d apart and the vertex c before, in the next row: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const k Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 2.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (>= (+ (* (- 1.0) c) (* 1.0 k)) 0.0))
(assert (>= (* (- 1.0) d k) 0.0))
(check-sat)
