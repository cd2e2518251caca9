; lemma-3.layers-top: the uppermost face, from its vertex to an upper corner x away
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const x Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d) 1.0) 0.0))
(assert (>= (+ (* 1.0 x) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 c) (* (- 1.0) x) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) c c d d) (* (/ 1.0 2.0) d d x x) (* (/ 1.0 2.0) d d d d)) 0.0))
(check-sat)
