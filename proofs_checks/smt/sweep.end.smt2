; sweep.end: on a level i strictly between those of its ends, j and k, an edge is between them
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const i Real)
(declare-const j Real)
(declare-const k Real)
(assert (> (+ (* 1.0 i) (* (- 1.0) j)) 0.0))
(assert (> (+ (* (- 1.0) i) (* 1.0 k)) 0.0))
(assert (> (* 1.0 a) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 b)) 0.0))
(assert (>= (+ (* 1.0 a i) (* (- 1.0) a k) (* (- 1.0) b i) (* 1.0 b j)) 0.0))
(check-sat)
