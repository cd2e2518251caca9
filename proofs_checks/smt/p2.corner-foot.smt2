; p2.corner-foot: with the foot after p
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const y Real)
(assert (> (* 1.0 k) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (> (+ (* 1.0 k) (* (- 4.0) y)) 0.0))
(assert (>= (+ (* (- 1.0) k k y) (* (- (/ 1.0 2.0)) k) (* 1.0 y)) 0.0))
(check-sat)
