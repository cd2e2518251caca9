; gaps.foot-near: v, x beside the near corner of a leg of slope y < 1/2, is 0.0599 from the leg
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 x x y y) (* (- (/ 358801.0 100000000.0)) y y) (- (/ 358801.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x x y y) (* (- 1.0) x x) (/ 4489.0 250000.0)) 0.0))
(check-sat)
