; slanted.low-ratio-next: v is y^2, y e the place of the next leader, w is D^2, q is e^2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const w Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 w) (- (/ 1.0 2.0))) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* 1.0 q) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) q) (* 1.0 w) (/ 1.0 2.0)) 0.0))
(assert (> (+ (* 2.0 q y) (* (- 1.0) q) (- (/ 1.0 2.0))) 0.0))
(assert (> (+ (* (- 4.0) w y y) (* (- 2.0) y y) (* 1.0 w) (/ 3.0 2.0)) 0.0))
(check-sat)
