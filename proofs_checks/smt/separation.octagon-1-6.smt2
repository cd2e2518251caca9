; separation.octagon-1-6: vertex 1 of K1 and a point of the edge 6 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (/ 875481.0 2000000.0) t) (- (/ 1216073.0 4000000.0))) 0.0))
(check-sat)
