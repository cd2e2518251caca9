; lemma-3.fan-last: a vertex on the last e at x >= L/4 is f1 from the upper side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const w Real)
(declare-const x Real)
(declare-const xi Real)
(assert (> (* 1.0 w) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (>= (+ (* 1.0 xi) (- 1.0)) 0.0))
(assert (>= (+ (* 4.0 x) (* (- 1.0) xi)) 0.0))
(assert (> (+ (* (- 4.0) h h x x) (* (- 144.0) w w x x) (* 9.0 w w xi xi)) 0.0))
(check-sat)
