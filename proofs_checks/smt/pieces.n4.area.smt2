; pieces.n4.area: (A, z, B): counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const e Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 e) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- 1.0) e) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 D) (- 4.0)) 0.0))
(assert (>= (* (- (/ 4.0 5.0)) D) 0.0))
(check-sat)
