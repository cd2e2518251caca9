; layers.end-right.height-3: A, the apex c beyond v, v = (x, r + d): the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const r Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 r) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 c) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) c d r x) (* (- 2.0) c d d x) (* (- 2.0) c c d r) (* (- 1.0) c c d d) (* (- 1.0) c c r r) (* (- 1.0) d d x x) (* (/ 18.0 25.0) c x) (* (/ 9.0 25.0) c c) (* (/ 9.0 25.0) r r) (* (/ 9.0 25.0) x x)) 0.0))
(check-sat)
