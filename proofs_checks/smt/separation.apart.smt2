; separation.apart: |d + k| >= |d| - rho, d = (D, 0), |k| <= rho
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const R Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 D) (* (- 1.0) R)) 0.0))
(assert (>= (+ (* 1.0 R) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 R R) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (> (+ (* (- 2.0) D R) (* (- 2.0) D x) (* 1.0 R R) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(check-sat)
