; slanted.tilt-before: its ends differ from points that are 1 apart by 2 k at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 D) (- 1.0)) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r) (/ 4247.0 5000.0)) 0.0))
(assert (> (+ (* (- 1.0) D) (* 1.0 r) (/ 753.0 5000.0)) 0.0))
(check-sat)
