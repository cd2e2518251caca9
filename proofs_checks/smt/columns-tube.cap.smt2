; columns-tube.cap: (p, u, v) on a part of an edge of a cap: the height over p-u
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const r Real)
(declare-const t Real)
(assert (>= (+ (* 1.0 q) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 t) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r) (/ 4701.0 10000.0)) 0.0))
(assert (> (+ (* (- 1.0) q t) (* (/ 223.0 10000.0) r)) 0.0))
(check-sat)
