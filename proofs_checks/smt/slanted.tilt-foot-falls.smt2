; slanted.tilt-foot-falls: flatter than 1/2; e' falls
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* 1.0 y) (* (- 1.0) z) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (* 1.0 z) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 z) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 x) (* (- 2.0) z)) 0.0))
(assert (> (+ (* 1.0 x y) (* (- 1.0) x z) (* (- (/ 1.0 2.0)) x x) (* (- (/ 1.0 2.0)) y z)) 0.0))
(check-sat)
