; section-5.foot-inside: the foot of the height onto a longest side is not before it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const w Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 y) 0.0))
(assert (>= (+ (* 1.0 w w) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (>= (+ (* 2.0 w x) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (> (* (- 1.0) x) 0.0))
(check-sat)
