; layers.split: (A, u, B), A B of F or more, and less than w; u at most v beside its far end
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const t Real)
(declare-const v Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- (/ 599.0 464.0)) t)) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (/ 375.0 116.0) t)) 0.0))
(assert (>= (* 1.0 v) 0.0))
(assert (>= (+ (* 1.0 D) (* (- 1.0) v) 2.0) 0.0))
(assert (> (+ (* (/ 49729.0 215296.0) t t v v) (* (- 1.0) D D) (* (/ 49729.0 215296.0) t t)) 0.0))
(check-sat)
