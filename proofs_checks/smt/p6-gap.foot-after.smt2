; p6-gap.foot-after: the foot of the T-vertex is not before the spoke
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const L Real)
(declare-const T Real)
(assert (>= (+ (* 1.0 L) (- 6.0)) 0.0))
(assert (>= (+ (* 1.0 T) (- 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 9.0 4.0)) 0.0))
(assert (> (* 1.0 H) 0.0))
(assert (>= (+ (* (- 1.0) H) (/ 9.0 17.0)) 0.0))
(assert (>= (+ (* (- (/ 1.0 2.0)) L T) (* (/ 1.0 8.0) L) (* (/ 1.0 4.0) T) (- (/ 1.0 16.0))) 0.0))
(check-sat)
