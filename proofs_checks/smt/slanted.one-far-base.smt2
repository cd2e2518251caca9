; slanted.one-far-base: (z, C, D), z is y from e', of length p: the height from z
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const y Real)
(assert (>= (+ (* 1.0 y) (- (/ 29.0 250.0))) 0.0))
(assert (> (+ (* (- 1.0) y y) (/ 841.0 390625.0)) 0.0))
(check-sat)
