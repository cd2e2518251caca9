; slanted.low-top-below: a member against A-B
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const T Real)
(declare-const c Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 T) (- (/ 987.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 c) (- (/ 31.0 40.0))) 0.0))
(assert (>= (+ (* (- 1.0) c) (/ 4.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 1.0 2.0))) 0.0))
(assert (>= (+ (* (- 1.0) y) 1.0) 0.0))
(assert (> (+ (* (- 1.0) c y) (* 1.0 T)) 0.0))
(check-sat)
