; wedges.w4.area: vr, BL, u: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const M Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (- (/ 3.0 20.0))) 0.0))
(assert (>= (+ (* 2.0 H) (* (- 1.0) M) (* 1.0 s)) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 2.0) H) (* 1.0 M)) 0.0))
(assert (>= (* (- 1.0) H s) 0.0))
(check-sat)
