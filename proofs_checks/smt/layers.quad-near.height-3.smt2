; layers.quad-near.height-3: two neighbours d apart and the vertex c before, in the next row: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const k Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 2.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (>= (+ (* (- 1.0) c) (* 1.0 k)) 0.0))
(assert (> (+ (* (- 1.0) d d k k) (* (/ 9.0 25.0) d d)) 0.0))
(check-sat)
