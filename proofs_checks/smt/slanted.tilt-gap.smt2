; slanted.tilt-gap: neighbours on e'
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 s s x x) (* 1.0 x x) (- (/ 4489.0 250000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 599.0 5000.0)) 0.0))
(check-sat)
