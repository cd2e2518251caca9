; pieces.hub-side.height-1: A, u_0, hub: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const c Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- (/ 599.0 464.0)) t)) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (/ 375.0 116.0) t)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (> (+ (* 2.0 D c t t) (* 1.0 D D t t) (* 1.0 c c t t) (* (- 1.0) D D) (* 1.0 t t)) 0.0))
(assert (> (+ (* 1.0 D c t t) (* (/ 1.0 4.0) D D t t) (* 1.0 c c t t) (* (- (/ 1.0 5.0)) D c) (* (- (/ 1.0 4.0)) D D) (* (- (/ 1.0 25.0)) c c) (* (/ 16.0 25.0) t t)) 0.0))
(check-sat)
