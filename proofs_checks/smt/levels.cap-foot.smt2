; levels.cap-foot: no foot is so far from the corner
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 58.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) x) (/ 667.0 2000.0)) 0.0))
(check-sat)
