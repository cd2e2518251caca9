; pieces.n3-member: a member, W before E, and a point of E-a, x beyond E, v above the member
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(declare-const v Real)
(declare-const x Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 W) (* (- (/ 217.0 100.0)) t)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (> (+ (* (- 2.0) W x) (* (- 1.0) W W) (* 1.0 t t) (* (- 1.0) v v) (* (- 1.0) x x)) 0.0))
(check-sat)
