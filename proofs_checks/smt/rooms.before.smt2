; rooms.before: the nearest of w is z < v, where v could be chosen: then w < v
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const v Real)
(declare-const w Real)
(declare-const z Real)
(assert (> (+ (* 1.0 v) (* (- 1.0) z)) 0.0))
(assert (>= (+ (* (- 2.0) v w) (* 1.0 v v) (* 2.0 w z) (* (- 1.0) z z)) 0.0))
(assert (>= (+ (* (- 1.0) v) (* 1.0 w)) 0.0))
(check-sat)
