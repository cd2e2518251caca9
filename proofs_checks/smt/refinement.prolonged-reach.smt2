; refinement.prolonged-reach: for b <= 1/4, tan of half of 90 degrees, it is within sqrt(2)/4 of v
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(assert (> (* 1.0 b) 0.0))
(assert (>= (+ (* (- 4.0) b) 1.0) 0.0))
(assert (> (+ (* 1.0 b b) (- (/ 1.0 16.0))) 0.0))
(check-sat)
