; pieces.hub-top.height-2: A, hub, B: the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- (/ 599.0 464.0)) t)) 0.0))
(assert (> (+ (* 1.0 D D t t) (* (- (/ 1.0 25.0)) D D)) 0.0))
(check-sat)
