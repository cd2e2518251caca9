; section-5.longest-side: 4 H^2 <= 3 w^2 over a longest side w
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const w Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 y) 0.0))
(assert (>= (+ (* 1.0 w w) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (>= (+ (* 2.0 w x) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (> (+ (* (- 3.0) w w) (* 4.0 y y)) 0.0))
(check-sat)
