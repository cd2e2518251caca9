; levels.cap-chord: no level lies strictly between the ends of an edge of a cap
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const j Real)
(assert (>= (+ (* 1.0 a) (* (- 1.0) b) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 j) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 b) (* (- 1.0) j) (- 1.0)) 0.0))
(check-sat)
