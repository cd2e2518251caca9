; slanted.low-inset: insets are half the least gap or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const q Real)
(assert (>= (+ (* 1.0 q) (- (/ 599.0 5000.0))) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 1.0) h) (/ 599.0 5000.0)) 0.0))
(check-sat)
