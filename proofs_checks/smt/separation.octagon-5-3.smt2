; separation.octagon-5-3: vertex 5 of K1 and a point of the edge 3 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 841.0 15625.0)) t t) (- (/ 644989.0 1000000.0))) 0.0))
(check-sat)
