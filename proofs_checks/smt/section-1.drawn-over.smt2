; section-1.drawn-over: a point nearer than t/2 to a and to b: a and b are nearer than t
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const ax Real)
(declare-const ay Real)
(declare-const bx Real)
(declare-const by Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (> (+ (* (- 4.0) ax ax) (* (- 4.0) ay ay) (* 1.0 t t)) 0.0))
(assert (> (+ (* (- 4.0) bx bx) (* (- 4.0) by by) (* 1.0 t t)) 0.0))
(assert (>= (+ (* (- 2.0) ax bx) (* 1.0 ax ax) (* (- 2.0) ay by) (* 1.0 ay ay) (* 1.0 bx bx) (* 1.0 by by) (* (- 1.0) t t)) 0.0))
(check-sat)
