; nested.n5-place-wide: 0 <= u, W >= 2: a = u + W - 1 >= 1 + u/2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const u Real)
(assert (>= (* 1.0 u) 0.0))
(assert (>= (+ (* 1.0 W) (- 2.0)) 0.0))
(assert (> (+ (* (- 1.0) W) (* (- (/ 1.0 2.0)) u) 2.0) 0.0))
(check-sat)
