; section-5.height-squared: H^4 <= 3 T^2 for the area T = w H/2 of a triangle on its longest side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const w Real)
(declare-const y Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 y) 0.0))
(assert (>= (+ (* 3.0 w w) (* (- 4.0) y y)) 0.0))
(assert (> (+ (* (- (/ 3.0 4.0)) w w y y) (* 1.0 y y y y)) 0.0))
(check-sat)
