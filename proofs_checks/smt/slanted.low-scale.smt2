; slanted.low-scale: 0.0464/h is 0.0987 or more and 1/5 or less
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const T Real)
(declare-const h Real)
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (= (+ (* 1.0 T h) (- (/ 29.0 625.0))) 0.0))
(assert (> (+ (* (- 1.0) T) (/ 987.0 10000.0)) 0.0))
(check-sat)
