; slanted.tilt-level: level
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 x) (- (/ 43.0 625.0))) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (> (+ (* (- (/ 169.0 50.0)) x) (* 1.0 y)) 0.0))
(check-sat)
