; tall.over: (t, L, s), p = -P and x >= 0: it turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const P Real)
(declare-const h Real)
(declare-const x Real)
(assert (>= (* 1.0 P) 0.0))
(assert (>= (+ (* (- 1.0) P) (/ 2977.0 10000.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 P) (* 2.0 x) (- (/ 83.0 1000.0))) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 2023.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 2977.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) h x) (* (- (/ 1.0 8.0)) P)) 0.0))
(check-sat)
