; offset.separation: 1 - 2 rho >= 0.0599 for rho^2 = a^2 + 4 g^2, the longer of the two reaches
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r r) (/ 220921.0 1000000.0)) 0.0))
(assert (> (+ (* 2.0 r) (- (/ 9401.0 10000.0))) 0.0))
(check-sat)
