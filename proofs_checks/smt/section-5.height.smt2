; section-5.height: H <= 4/3 for an area w H/2 <= 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const w Real)
(declare-const y Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 y) 0.0))
(assert (>= (+ (* 3.0 w w) (* (- 4.0) y y)) 0.0))
(assert (>= (+ (* (- 1.0) w y) 2.0) 0.0))
(assert (> (+ (* 3.0 y) (- 4.0)) 0.0))
(check-sat)
