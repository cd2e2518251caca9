; section-1.spoke-distance-most: its distance is 1 over the chord's length, at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const k Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 k) (- 3.0)) 0.0))
(assert (>= (+ (* (- 2.0) k) (* 1.0 r)) 0.0))
(assert (>= (+ (* 2.0 X) (* 1.0 k) (* (- 1.0) r) (- 4.0)) 0.0))
(assert (> 0.0 0.0))
(check-sat)
