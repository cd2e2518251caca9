; slanted.fan-apex: (A, v, w): the height from A
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const h Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 2.0 c) (* (- 1.0) h) (- (/ 599.0 5000.0))) 0.0))
(assert (> (+ (* (- 1.0) c c) (* (/ 841.0 390625.0) s s) (/ 841.0 390625.0)) 0.0))
(check-sat)
