; wedges.w3.area: vr, vr', BL; vr = (0,0), vr' is d below, BL = (x,-H), x > 2 H: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const d Real)
(declare-const x Real)
(assert (> (+ (* (- 2.0) H) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 599.0 10000.0))) 0.0))
(assert (> (+ (* 1.0 H) (* (- 1.0) d)) 0.0))
(assert (>= (* (- 1.0) d x) 0.0))
(check-sat)
