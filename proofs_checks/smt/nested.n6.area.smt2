; nested.n6.area: fan: (A, u, u + W), both within 2: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(declare-const u Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 957.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 W) (* (- (/ 603.0 100.0)) t)) 0.0))
(assert (>= (+ (* 1.0 u) 2.0) 0.0))
(assert (>= (+ (* (- 1.0) W) (* (- 1.0) u) 2.0) 0.0))
(assert (>= (* (- 1.0) W) 0.0))
(check-sat)
