; clean.a1-good: F is above Fp
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const P Real)
(assert (>= (+ (* 1.0 P) (- (/ 599.0 10000.0))) 0.0))
(assert (> (+ (* (- 1.0) P) (/ 29.0 500.0)) 0.0))
(check-sat)
