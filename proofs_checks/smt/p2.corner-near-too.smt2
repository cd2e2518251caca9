; p2.corner-near-too: also from the other side of it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const y Real)
(assert (> (* 1.0 k) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (> (+ (* 1.0 k) (* (- 4.0) y)) 0.0))
(assert (>= (+ (* (- 2.0) k y) (- (/ 1.0 2.0))) 0.0))
(check-sat)
