; tall.over-c: (t, L, s), p = -P and x >= 0: height c
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
(assert (> (+ (* (- 1.0) h h x x) (* (- (/ 1.0 4.0)) P h x) (* (- (/ 15049.0 1000000.0)) P P) (* (/ 9.0 15625.0) h h)) 0.0))
(check-sat)
