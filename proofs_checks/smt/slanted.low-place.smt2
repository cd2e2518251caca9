; slanted.low-place: an apex is at least h/2 from A: k is the inset, x the right end of the gap
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const k Real)
(declare-const x Real)
(assert (>= (+ (* (- 1.0) h) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 2.0) k)) 0.0))
(assert (> (+ (* 1.0 h) (* 2.0 k) (* (- 2.0) x)) 0.0))
(check-sat)
