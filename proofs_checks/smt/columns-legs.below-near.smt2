; columns-legs.below-near: else P1 is 0.0062 at most beside F0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 43.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 q) (* (- 1.0) x) (/ 3.0 40.0)) 0.0))
(assert (> (+ (* (- 1.0) q) (- (/ 31.0 5000.0))) 0.0))
(check-sat)
