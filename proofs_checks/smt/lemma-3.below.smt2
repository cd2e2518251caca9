; lemma-3.below: a point below e_i+1 by v >= 1/3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const v Real)
(assert (>= (+ (* 1.0 v) (- (/ 1.0 3.0))) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 3.0)) 0.0))
(assert (> (+ (* (/ 1.0 37.0) s s) (* (- 1.0) v v) (/ 1.0 37.0)) 0.0))
(check-sat)
