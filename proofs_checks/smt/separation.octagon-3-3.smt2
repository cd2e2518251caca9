; separation.octagon-3-3: vertex 3 of K1 and a point of the edge 3 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 9.0 400.0)) t t) (- (/ 115479.0 250000.0))) 0.0))
(check-sat)
