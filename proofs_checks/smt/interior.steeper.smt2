; interior.steeper: b beside the end of a leg that leans outwards by M, then by r: off its line
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const M Real)
(declare-const b Real)
(declare-const r Real)
(assert (>= (* 1.0 b) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 M) (* (- 1.0) r)) 0.0))
(assert (>= (+ (* 1.0 H H b b) (* (- (/ 358801.0 100000000.0)) H H) (* (- (/ 358801.0 100000000.0)) M M)) 0.0))
(assert (> (+ (* (- 1.0) H H b b) (* (/ 358801.0 100000000.0) H H) (* (/ 358801.0 100000000.0) r r)) 0.0))
(check-sat)
