; layers.end-right.area: A, the apex c beyond v, v = (x, r + d): counter-clockwise
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
(assert (>= (+ (* (- 1.0) c d) (* (- 1.0) c r) (* (- 1.0) d x)) 0.0))
(check-sat)
