; section-5.parts: 9 parts of each of q <= H/(2 e) slices are at most 6/e
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(declare-const q Real)
(declare-const y Real)
(assert (> (* 1.0 e) 0.0))
(assert (>= (* 1.0 q) 0.0))
(assert (>= (+ (* (- 3.0) y) 4.0) 0.0))
(assert (>= (+ (* (- 2.0) e q) (* 1.0 y)) 0.0))
(assert (> (+ (* 9.0 e q) (- 6.0)) 0.0))
(check-sat)
