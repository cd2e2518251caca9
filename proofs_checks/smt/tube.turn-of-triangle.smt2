; tube.turn-of-triangle: 12 m / sqrt 3 <= 0.3315: 3 s^2 <= 4 0.3315^2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 8.0 s s s s) (* (- 8.0) s s) 1.0) 0.0))
(assert (> (+ (* 3.0 s s) (- (/ 439569.0 1000000.0))) 0.0))
(check-sat)
