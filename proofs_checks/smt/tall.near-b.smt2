; tall.near-b: (t, L, s), p >= 0 and x = p + z: height b
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const p Real)
(declare-const z Real)
(assert (>= (* 1.0 p) 0.0))
(assert (>= (+ (* 2.0 z) (- (/ 83.0 1000.0))) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 2023.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 2977.0 10000.0)) 0.0))
(assert (> (+ (* (- 2.0) h h p z) (* (- 1.0) h h p p) (* (- 1.0) h h z z) (* (/ 1.0 4.0) h p z) (* (/ 1.0 4.0) h p p) (* (/ 9.0 15625.0) h h) (* (- (/ 1.0 64.0)) p p) (* (/ 9.0 15625.0) z z) (* (- (/ 9.0 62500.0)) h) (/ 9.0 1000000.0)) 0.0))
(check-sat)
