; separation.octagon-2-2: vertex 2 of K1 and a point of the edge 2 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 841.0 15625.0)) t t) (* (- (/ 1682.0 15625.0)) t) (- (/ 212077.0 800000.0))) 0.0))
(check-sat)
