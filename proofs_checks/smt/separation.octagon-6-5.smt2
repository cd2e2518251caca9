; separation.octagon-6-5: vertex 6 of K1 and a point of the edge 5 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (/ 5046.0 15625.0) t) (- (/ 115479.0 250000.0))) 0.0))
(check-sat)
