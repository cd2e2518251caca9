; pieces.n1-narrow.height-2: tooth over W <= 2, apex over the middle: the height from corner 2
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
(assert (> (+ (* (/ 1.0 4.0) W W t t) (* (- 1.0) W W y y) (* 1.0 t t y y)) 0.0))
(check-sat)
