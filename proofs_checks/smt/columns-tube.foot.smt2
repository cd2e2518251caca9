; columns-tube.foot: (A, foot, v), the foot q from A: the long side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 q) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 4701.0 10000.0)) 0.0))
(assert (> (+ (* (- 1.0) q q y y) (* (/ 49729.0 100000000.0) q q) (* (/ 49729.0 100000000.0) y y)) 0.0))
(check-sat)
