; results.below-45: what the Tube keeps is more than mfs/45
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const M Real)
(declare-const f Real)
(declare-const m Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* 1.0 M) (* (- 1.0) m)) 0.0))
(assert (>= (+ (* (- 1.0) M) (* (/ 1000001.0 1000000.0) m)) 0.0))
(assert (>= (+ (* 1.0 f) (* (- (/ 223.0 10000.0)) m)) 0.0))
(assert (>= (+ (* 1.0 M) (* (- 45.0) f)) 0.0))
(check-sat)
