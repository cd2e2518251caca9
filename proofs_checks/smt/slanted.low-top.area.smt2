; slanted.low-top.area: (A, B, z): counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const T Real)
(declare-const e Real)
(assert (> (* 1.0 T) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 223.0 2320.0)) 0.0))
(assert (>= (+ (* 2.0 e) (- 1.0)) 0.0))
(assert (>= (+ (* 2.0 D) (* (- 2.0) e) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 D) (- 2.0)) 0.0))
(assert (>= (* (- (/ 4.0 5.0)) D) 0.0))
(check-sat)
