; sweep.order: d and e, how far an edge is right of another on two levels, not negative, not both 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const e Real)
(declare-const t Real)
(assert (>= (* 1.0 d) 0.0))
(assert (>= (* 1.0 e) 0.0))
(assert (> (+ (* 1.0 d) (* 1.0 e)) 0.0))
(assert (> (* 1.0 t) 0.0))
(assert (> (+ (* (- 1.0) t) 1.0) 0.0))
(assert (>= (+ (* 1.0 d t) (* (- 1.0) e t) (* (- 1.0) d)) 0.0))
(check-sat)
