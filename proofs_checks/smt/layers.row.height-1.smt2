; layers.row.height-1: A, the first of a row, d farther, e high, and the first of the row k above: the height from corner 1
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
(assert (> (+ (* (- 2.0) d e k x) (* (- 2.0) d k k x) (* (- 2.0) d d e k) (* (- 1.0) d d e e) (* (- 1.0) d d k k) (* (- 1.0) k k x x) (* (/ 9.0 25.0) d d) (* (/ 9.0 25.0) k k)) 0.0))
(check-sat)
