; lemma-3.layers-end-low: its side to the lower row
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const g Real)
(declare-const p Real)
(declare-const y Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 2.0) d) (* 1.0 y)) 0.0))
(assert (>= (+ (* (- 1.0) y) 1.0) 0.0))
(assert (>= (+ (* 1.0 p) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 g) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) d g p y) (* (- (/ 1.0 2.0)) d d p p) (* (/ 1.0 2.0) d d y y) (* (- 1.0) g g y y)) 0.0))
(check-sat)
