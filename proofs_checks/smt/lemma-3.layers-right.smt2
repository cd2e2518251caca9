; lemma-3.layers-right: a right triangle over g >= 1, v high, d <= v <= 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const g Real)
(declare-const v Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) d) (* 1.0 v)) 0.0))
(assert (>= (+ (* (- 1.0) v) 1.0) 0.0))
(assert (>= (+ (* 1.0 g) (- 1.0)) 0.0))
(assert (> (+ (* (/ 1.0 2.0) d d g g) (* (/ 1.0 2.0) d d v v) (* (- 1.0) g g v v)) 0.0))
(check-sat)
