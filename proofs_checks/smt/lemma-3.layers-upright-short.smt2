; lemma-3.layers-upright-short: where both rows end at one abscissa: the vertical side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const p Real)
(declare-const y Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 2.0) d) (* 1.0 y)) 0.0))
(assert (>= (+ (* (- 1.0) y) 1.0) 0.0))
(assert (>= (+ (* 1.0 p) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) d d p p) (* (/ 1.0 2.0) d d d d)) 0.0))
(check-sat)
