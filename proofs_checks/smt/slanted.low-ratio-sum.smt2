; slanted.low-ratio-sum: e and D together
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const e Real)
(assert (>= (* 1.0 D) 0.0))
(assert (>= (+ (* 1.0 D D) (* (- 1.0) e e) (/ 1.0 2.0)) 0.0))
(assert (> (+ (* 2.0 D e) (* (- 3.0) D D) (* 1.0 e e) (- 1.0)) 0.0))
(check-sat)
