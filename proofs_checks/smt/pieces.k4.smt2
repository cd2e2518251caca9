; pieces.k4: a base at F or more from a leg that leans by r, not more than that from the anchor
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const r Real)
(declare-const t Real)
(declare-const v Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* (- (/ 358801.0 215296.0)) r r t t) (* 1.0 W W) (* (- (/ 358801.0 215296.0)) t t)) 0.0))
(assert (>= (* 1.0 v) 0.0))
(assert (>= (+ (* 1.0 r) (* (- 1.0) v)) 0.0))
(assert (> (+ (* 1.0 t t v v) (* (- 1.0) W W) (* 1.0 t t)) 0.0))
(check-sat)
