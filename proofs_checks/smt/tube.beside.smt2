; tube.beside: points on either side of a strip r wide, across T', are r apart
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(declare-const u Real)
(declare-const x Real)
(declare-const y Real)
(declare-const y2 Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r) (* 1.0 x)) 0.0))
(assert (>= (* 1.0 u) 0.0))
(assert (> (+ (* 1.0 r r) (* (- 2.0) u x) (* (- 1.0) u u) (* (- 1.0) x x) (* 2.0 y y2) (* (- 1.0) y y) (* (- 1.0) y2 y2)) 0.0))
(check-sat)
