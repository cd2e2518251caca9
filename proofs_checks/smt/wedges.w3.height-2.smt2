; wedges.w3.height-2: vr, vr', BL; vr = (0,0), vr' is d below, BL = (x,-H), x > 2 H: the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const d Real)
(declare-const x Real)
(assert (> (+ (* (- 2.0) H) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 599.0 10000.0))) 0.0))
(assert (> (+ (* 1.0 H) (* (- 1.0) d)) 0.0))
(assert (> (+ (* (- 1.0) d d x x) (* (/ 841.0 390625.0) H H) (* (/ 841.0 390625.0) x x)) 0.0))
(check-sat)
