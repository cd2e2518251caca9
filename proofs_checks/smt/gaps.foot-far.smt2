; gaps.foot-far: a foot is 2 H or more beside the far corner
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 58.0 125.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 67.0 500.0)) 0.0))
(check-sat)
