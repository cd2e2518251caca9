; layers.row.area: A, the first of a row, d farther, e high, and the first of the row k above: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const e Real)
(declare-const k Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 e) (* (- 1.0) k)) 0.0))
(assert (>= (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) e) (* (- 1.0) k) (* 1.0 x)) 0.0))
(assert (>= (+ (* (- 1.0) d e) (* (- 1.0) d k) (* (- 1.0) k x)) 0.0))
(check-sat)
