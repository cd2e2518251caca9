; refinement.nearest-end: at an angle of 90 degrees or more the nearest point is the vertex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const ux Real)
(declare-const uy Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 b) 0.0))
(assert (>= (+ (* (- 1.0) ux x) (* (- 1.0) uy y)) 0.0))
(assert (> (+ (* 1.0 x x) (* 1.0 y y)) 0.0))
(assert (> (+ (* (- 1.0) b b ux ux) (* (- 1.0) b b uy uy) (* 2.0 b ux x) (* 2.0 b uy y)) 0.0))
(check-sat)
