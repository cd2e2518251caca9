; layers.top.area: A, B and the last row: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const k Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) k) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- 1.0) k) (* (- 1.0) x)) 0.0))
(assert (>= (* (- 1.0) D k) 0.0))
(check-sat)
