; lemma-3.layers-between: (u, v, v') with v' v on the row above, c apart, v being b away
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d) 1.0) 0.0))
(assert (>= (+ (* 1.0 b) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) b) (* 1.0 c) (- 1.0)) 0.0))
(assert (> (+ (* (/ 1.0 2.0) b b d d) (* (- 1.0) c c d d) (* (/ 1.0 2.0) d d d d)) 0.0))
(check-sat)
