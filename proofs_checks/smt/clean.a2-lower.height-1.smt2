; clean.a2-lower.height-1: good BL: triangle BL, BR, TR: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const b Real)
(declare-const x Real)
(assert (> (* 1.0 b) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 H H b b) (* (- (/ 841.0 250000.0)) H H) (* (/ 841.0 125000.0) b x) (* (- (/ 841.0 250000.0)) b b) (* (- (/ 841.0 250000.0)) x x)) 0.0))
(assert (> (+ (* (- 1.0) H H b b) (* (/ 841.0 390625.0) H H) (* (- (/ 1682.0 390625.0)) b x) (* (/ 841.0 390625.0) b b) (* (/ 841.0 390625.0) x x)) 0.0))
(check-sat)
