; results.design: what all faces keep is mfs/21.6 or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const M Real)
(declare-const f Real)
(declare-const m Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* 1.0 M) (* (- 1.0) m)) 0.0))
(assert (>= (+ (* (- 1.0) M) (* (/ 1000001.0 1000000.0) m)) 0.0))
(assert (>= (+ (* 1.0 f) (* (- (/ 29.0 625.0)) m)) 0.0))
(assert (> (+ (* 1.0 M) (* (- (/ 108.0 5.0)) f)) 0.0))
(check-sat)
