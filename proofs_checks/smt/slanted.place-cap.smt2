; slanted.place-cap: C is of a cap at B, or of a common k
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const b Real)
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) L) (* 1.0 b) (/ 4701.0 10000.0)) 0.0))
(assert (>= (* (- 1.0) b) 0.0))
(check-sat)
