; pieces.narrow: a gap that ends beyond 2, at F or more from the line of A and its beginning
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const p Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (> (* 1.0 W) 0.0))
(assert (> (+ (* 1.0 W) (* 1.0 p) (- 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) W) (* (/ 375.0 116.0) t)) 0.0))
(assert (>= (+ (* (- (/ 358801.0 215296.0)) p p t t) (* 1.0 W W) (* (- (/ 358801.0 215296.0)) t t)) 0.0))
(assert (> (+ (* (- 1.0) W) (* (/ 217.0 100.0) t)) 0.0))
(check-sat)
