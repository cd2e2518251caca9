; slanted.low-middle: so is the middle of e
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const h Real)
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (> (+ (* (- 1.0) L) (* 1.0 h)) 0.0))
(check-sat)
