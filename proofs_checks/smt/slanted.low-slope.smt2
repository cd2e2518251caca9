; slanted.low-slope: the root of 1 + s^2 is 1 + s^2/2 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 2.0)) 0.0))
(assert (> (* (- (/ 1.0 4.0)) s s s s) 0.0))
(check-sat)
