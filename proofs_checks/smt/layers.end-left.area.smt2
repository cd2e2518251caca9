; layers.end-left.area: A, the apex at p >= r, v = (-x, r + d): counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const p Real)
(declare-const r Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 r) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 p) (* (- 1.0) r)) 0.0))
(assert (>= (+ (* (- 1.0) d p) (* (- 1.0) p r) (* (- 1.0) r x)) 0.0))
(check-sat)
