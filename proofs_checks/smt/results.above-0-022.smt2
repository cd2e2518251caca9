; results.above-0-022: and more than 0.022 mfs
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const M Real)
(declare-const f Real)
(declare-const m Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* 1.0 M) (* (- 1.0) m)) 0.0))
(assert (>= (+ (* (- 1.0) M) (* (/ 1000001.0 1000000.0) m)) 0.0))
(assert (>= (+ (* 1.0 f) (* (- (/ 223.0 10000.0)) m)) 0.0))
(assert (>= (+ (* (/ 11.0 500.0) M) (* (- 1.0) f)) 0.0))
(check-sat)
