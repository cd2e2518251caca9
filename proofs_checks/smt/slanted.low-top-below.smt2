; slanted.low-top-below: a member against A-B
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const T Real)
(declare-const y Real)
(assert (> (* 1.0 T) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 223.0 2320.0)) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 1.0 2.0))) 0.0))
(assert (>= (+ (* (- 1.0) y) 1.0) 0.0))
(assert (> (+ (* 1.0 T) (* (- (/ 4.0 5.0)) y)) 0.0))
(check-sat)
