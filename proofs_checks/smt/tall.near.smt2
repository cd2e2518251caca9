; tall.near: (t, L, s), p >= 0 and x = p + z: it turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const p Real)
(declare-const z Real)
(assert (>= (* 1.0 p) 0.0))
(assert (>= (+ (* 2.0 z) (- (/ 83.0 1000.0))) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 2023.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 2977.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) h p) (* (- 1.0) h z) (* (/ 1.0 8.0) p)) 0.0))
(check-sat)
