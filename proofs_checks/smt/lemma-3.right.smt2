; lemma-3.right: a right triangle over a whole number a >= 1 and v >= 1/3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const v Real)
(assert (>= (+ (* 1.0 a) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 v) (- (/ 1.0 3.0))) 0.0))
(assert (> (+ (* (- 1.0) a a v v) (* (/ 1.0 37.0) a a) (* (/ 1.0 37.0) v v)) 0.0))
(check-sat)
