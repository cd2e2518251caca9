; wedges.w1.height-1: TL, v1', v1; s is the slope of the leg, below 1/2: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const s Real)
(assert (> (* 1.0 c) 0.0))
(assert (> (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 1.0 c c s s) (* (- (/ 358801.0 100000000.0)) s s) (- (/ 358801.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) c c c c s s) (* (/ 841.0 390625.0) c c s s)) 0.0))
(check-sat)
