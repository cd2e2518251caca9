; pieces.n4-members-ab: a member, at the fraction y of A-z, against A-B
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(declare-const y Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 2.0 y) (- 1.0)) 0.0))
(assert (> (+ (* 1.0 t) (* (- (/ 4.0 5.0)) y)) 0.0))
(check-sat)
