; pieces.n4.height-3: (A, z, B): the height from corner 3
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
(assert (> (+ (* 1.0 e e t t) (* (- (/ 16.0 25.0)) D D) (* (/ 16.0 25.0) t t)) 0.0))
(check-sat)
