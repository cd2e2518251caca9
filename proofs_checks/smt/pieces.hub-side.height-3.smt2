; pieces.hub-side.height-3: A, u_0, hub: the height from the hub; twice the area is D/2 + c/5, and 1/5 >= t
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
(assert (> (+ (* (- 1.0) D c t) (* (- (/ 1.0 4.0)) D D) (* 1.0 t t)) 0.0))
(check-sat)
