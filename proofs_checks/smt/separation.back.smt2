; separation.back: k = (x, y) with |k| <= rho has x >= -rho
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const R Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 R) 0.0))
(assert (>= (+ (* 1.0 R R) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (> (+ (* (- 1.0) R) (* (- 1.0) x)) 0.0))
(check-sat)
