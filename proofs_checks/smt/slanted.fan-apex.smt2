; slanted.fan-apex: (A, v, w): the height from A
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 c) (- (/ 1759.0 10000.0))) 0.0))
(assert (> (+ (* (- 1.0) c c) (* (/ 49729.0 100000000.0) s s) (/ 49729.0 100000000.0)) 0.0))
(check-sat)
