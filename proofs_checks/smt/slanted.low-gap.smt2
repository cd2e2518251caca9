; slanted.low-gap: a gap is 2.58 T: 0.1198/h
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const T Real)
(declare-const h Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (= (+ (* 1.0 T h) (- (/ 29.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 h x) (- (/ 599.0 5000.0))) 0.0))
(assert (> (+ (* (/ 129.0 50.0) T) (* (- 1.0) x)) 0.0))
(check-sat)
