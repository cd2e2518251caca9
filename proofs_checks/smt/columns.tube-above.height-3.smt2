; columns.tube-above.height-3: the second foot, (W, u) above it, (0, t): the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(declare-const u Real)
(assert (>= (+ (* 1.0 W) (- (/ 3.0 50.0))) 0.0))
(assert (>= (+ (* 1.0 t) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) t) (* 1.0 u)) 0.0))
(assert (>= (+ (* (- 1.0) u) (/ 4701.0 10000.0)) 0.0))
(assert (> (+ (* (- 1.0) W W u u) (* (/ 841.0 390625.0) u u)) 0.0))
(check-sat)
