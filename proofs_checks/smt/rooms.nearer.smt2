; rooms.nearer: a vertex w between u and v is nearer to v than u is
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const u Real)
(declare-const v Real)
(declare-const w Real)
(assert (> (+ (* (- 1.0) u) (* 1.0 w)) 0.0))
(assert (> (+ (* 1.0 v) (* (- 1.0) w)) 0.0))
(assert (>= (+ (* 2.0 u v) (* (- 1.0) u u) (* (- 2.0) v w) (* 1.0 w w)) 0.0))
(check-sat)
