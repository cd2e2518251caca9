; wedges.w1.area: TL, v1', v1; s is the slope of the leg, below 1/2: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const s Real)
(assert (> (* 1.0 c) 0.0))
(assert (> (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 1.0 c c s s) (* (- (/ 358801.0 100000000.0)) s s) (- (/ 358801.0 100000000.0))) 0.0))
(assert (>= (* (- 1.0) c c s) 0.0))
(check-sat)
