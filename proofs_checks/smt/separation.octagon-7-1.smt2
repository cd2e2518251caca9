; separation.octagon-7-1: vertex 7 of K1 and a point of the edge 1 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 841.0 15625.0)) t t) (* (- (/ 1682.0 15625.0)) t) (- (/ 114037.0 800000.0))) 0.0))
(check-sat)
