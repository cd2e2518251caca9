; slanted.low-ratio-first: e is at most half as far out
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const e Real)
(assert (>= (* 1.0 e) 0.0))
(assert (>= (+ (* 1.0 D) (* (- 1.0) e)) 0.0))
(assert (> (+ (* (- 1.0) D) (* 1.0 e)) 0.0))
(check-sat)
