; tube.edge-of-triangle-before: so do 90 degrees in triangles: b, by >= 0, is farther than 663/2000 from the cone's side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const bx Real)
(declare-const by Real)
(assert (= (+ (* 1.0 bx bx) (* 1.0 by by) (- 1.0)) 0.0))
(assert (>= (* 1.0 by) 0.0))
(assert (>= (+ (* (- 1.0) by) 1.0) 0.0))
(assert (>= (* (- 1.0) bx) 0.0))
(assert (>= (+ (* 1.0 bx) 1.0) 0.0))
(assert (> (+ (* 8.0 bx) (* (- 15.0) by) (/ 11271.0 2000.0)) 0.0))
(check-sat)
