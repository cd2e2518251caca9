; p2.reflex: points below the x-axis are 1/4 or more from e'
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* (- 1.0) z) 0.0))
(assert (> (+ (* 2.0 x y) (* (- 1.0) x x) (* (- 1.0) y y) (* (- 1.0) z z) (* (/ 1.0 2.0) z)) 0.0))
(check-sat)
