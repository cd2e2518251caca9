; clean.a3-below.area: no good corner below: triangle BL, BR, centre: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const b Real)
(assert (>= (+ (* 1.0 b) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* (- (/ 1.0 2.0)) H b) 0.0))
(check-sat)
