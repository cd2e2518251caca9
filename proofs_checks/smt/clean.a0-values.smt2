; clean.a0-values: P >= g and Q >= Fp make P Q/(P + Q) >= f*
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const P Real)
(declare-const Q Real)
(assert (>= (+ (* 1.0 P) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 Q) (- (/ 29.0 500.0))) 0.0))
(assert (> (+ (* (- 1.0) P Q) (* (/ 29.0 625.0) P) (* (/ 29.0 625.0) Q)) 0.0))
(check-sat)
