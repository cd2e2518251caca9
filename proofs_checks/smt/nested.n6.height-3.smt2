; nested.n6.height-3: fan: (A, u, u + W), both within 2: the height from corner 3
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
(assert (> (+ (* 1.0 t t u u) (* (- 1.0) W W) (* 1.0 t t)) 0.0))
(check-sat)
