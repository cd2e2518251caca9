; layers.bound-few: what 0.0223 allows
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(assert (>= (+ (* 1.0 l) (- 2.0)) 0.0))
(assert (> (+ (* (- (/ 2453.0 5000.0)) l) (/ 509401.0 1000000.0)) 0.0))
(check-sat)
