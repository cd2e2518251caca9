; section-1.spoke-foot: the foot of a neighbour 1 beside the end of a chord is on the chord
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const k Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 k) (- 3.0)) 0.0))
(assert (>= (+ (* (- 2.0) k) (* 1.0 r)) 0.0))
(assert (>= (+ (* 2.0 X) (* 1.0 k) (* (- 1.0) r) (- 4.0)) 0.0))
(assert (> (* (- 1.0) X) 0.0))
(check-sat)
