; layers.end-left.height-3: A, the apex at p >= r, v = (-x, r + d): the height from corner 3
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
(assert (> (+ (* (- 2.0) d p r x) (* (- 2.0) d p p r) (* (- 1.0) d d p p) (* (- 2.0) p r r x) (* (- 1.0) p p r r) (* (- 1.0) r r x x) (* (/ 9.0 25.0) p p) (* (/ 9.0 25.0) r r)) 0.0))
(check-sat)
