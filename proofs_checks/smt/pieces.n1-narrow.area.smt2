; pieces.n1-narrow.area: tooth over W <= 2, apex over the middle: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(declare-const y Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 W) (* (- (/ 217.0 100.0)) t)) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 1.0 5.0))) 0.0))
(assert (>= (+ (* (- 1.0) W) 2.0) 0.0))
(assert (>= (* (- 1.0) W y) 0.0))
(check-sat)
