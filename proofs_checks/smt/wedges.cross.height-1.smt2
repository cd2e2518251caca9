; wedges.cross.height-1: cross edge: apex above a base of F or more: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const s Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 s) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 s) (* (- 1.0) x)) 0.0))
(assert (>= (+ (* 1.0 H) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 1.0) H H s s) (* (/ 841.0 390625.0) H H) (* (- (/ 1682.0 390625.0)) s x) (* (/ 841.0 390625.0) s s) (* (/ 841.0 390625.0) x x)) 0.0))
(check-sat)
