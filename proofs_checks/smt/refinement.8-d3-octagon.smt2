; refinement.8-d3-octagon: 16/sin(pi/8) < 45
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* (- 8.0) s s s s) (* 8.0 s s) (- 1.0)) 0.0))
(assert (>= (+ (* (- 45.0) s) 16.0) 0.0))
(check-sat)
