; p2.corner-far: e' is 1/4 or more from f
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const y Real)
(assert (>= (* 1.0 k) 0.0))
(assert (>= (+ (* (- 1.0) k) (* 4.0 y)) 0.0))
(assert (> (+ (* (- 2.0) k y) (* (/ 1.0 2.0) k k)) 0.0))
(check-sat)
