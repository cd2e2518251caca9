; p2.corner-near: before e' begins it is nearer than 1/4 to the line of f
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const y Real)
(assert (> (* 1.0 k) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (> (+ (* 1.0 k) (* (- 4.0) y)) 0.0))
(assert (>= (+ (* 2.0 k y) (* (- (/ 1.0 2.0)) k k)) 0.0))
(check-sat)
