; section-1.rectangle-distance: its distance is at most 2/r
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- 3.0)) 0.0))
(assert (> (+ (* (- 2.0) r) (- 5.0)) 0.0))
(check-sat)
