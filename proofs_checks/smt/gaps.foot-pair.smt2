; gaps.foot-pair: feet that are x >= 0.15 apart sideways
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 x) (- (/ 3.0 20.0))) 0.0))
(assert (> (+ (* (- 1.0) x x) (* (- 1.0) y y) (/ 4489.0 250000.0)) 0.0))
(check-sat)
