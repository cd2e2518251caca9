; separation.octagon-7-6: vertex 7 of K1 and a point of the edge 6 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (/ 172057.0 400000.0) t) (- (/ 212077.0 800000.0))) 0.0))
(check-sat)
