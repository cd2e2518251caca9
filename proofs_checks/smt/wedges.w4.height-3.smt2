; wedges.w4.height-3: vr, BL, u: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const M Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (- (/ 3.0 20.0))) 0.0))
(assert (>= (+ (* 2.0 H) (* (- 1.0) M) (* 1.0 s)) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 2.0) H) (* 1.0 M)) 0.0))
(assert (> (+ (* (- 1.0) H H s s) (* (/ 841.0 390625.0) H H) (* (/ 841.0 390625.0) M M)) 0.0))
(check-sat)
