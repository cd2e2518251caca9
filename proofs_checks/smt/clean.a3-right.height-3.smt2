; clean.a3-right.height-3: no good corner below: triangle BR, TR, centre: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const b Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 b) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (> (* 1.0 r) 0.0))
(assert (> (+ (* (- 1.0) b b) (* (/ 841.0 250000.0) r r) (/ 841.0 250000.0)) 0.0))
(assert (> (+ (* (- (/ 1.0 4.0)) H H H H r r) (* (- (/ 1.0 2.0)) H H H b r) (* (- (/ 1.0 4.0)) H H b b) (* (/ 841.0 390625.0) H H r r) (* (/ 841.0 390625.0) H H)) 0.0))
(check-sat)
