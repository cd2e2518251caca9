; separation.octagon-2-6: vertex 2 of K1 and a point of the edge 6 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 841.0 15625.0)) t t) (* (/ 3364.0 15625.0) t) (- (/ 1216073.0 4000000.0))) 0.0))
(check-sat)
