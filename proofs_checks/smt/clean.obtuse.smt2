; clean.obtuse: where the angle at the apex is not acute, p and q are r from the nearest point, the apex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const r Real)
(declare-const x Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 1.0) r)) 0.0))
(assert (> (+ (* (- 1.0) h h) (* 1.0 r r) (* (- 1.0) x x)) 0.0))
(check-sat)
