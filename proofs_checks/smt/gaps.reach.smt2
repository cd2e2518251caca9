; gaps.reach: K1 reaches 0.4247 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* (- 1.0) x x) (/ 721313.0 4000000.0)) 0.0))
(assert (> (+ (* 1.0 x) (- (/ 4247.0 10000.0))) 0.0))
(check-sat)
