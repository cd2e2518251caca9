; section-1.ear-ratio: a side is at least n/4 heights
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const n Real)
(declare-const side Real)
(assert (> (* 1.0 side) 0.0))
(assert (> (* 1.0 n) 0.0))
(assert (>= (+ (* (- 1.0) n side) 8.0) 0.0))
(assert (> (+ (* (/ 1.0 2.0) n side side) (* (- 4.0) side)) 0.0))
(check-sat)
