; clean.a3-below.height-1: no good corner below: triangle BL, BR, centre: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const b Real)
(assert (>= (+ (* 1.0 b) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- (/ 1.0 4.0)) H H b b) (* (/ 841.0 1562500.0) H H) (* (/ 841.0 1562500.0) b b)) 0.0))
(check-sat)
