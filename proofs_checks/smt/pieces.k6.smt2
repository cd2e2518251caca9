; pieces.k6: a base of F or more, not more than w from the anchor
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(declare-const v Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 W) (* (- (/ 599.0 464.0)) t)) 0.0))
(assert (>= (* 1.0 v) 0.0))
(assert (>= (+ (* (/ 375.0 116.0) t) (* (- 1.0) v)) 0.0))
(assert (> (+ (* 1.0 t t v v) (* (- 1.0) W W) (* 1.0 t t)) 0.0))
(check-sat)
