; separation.octagon-5-1: vertex 5 of K1 and a point of the edge 1 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 9.0 400.0)) t t) (* (- (/ 2001.0 20000.0)) t) (- (/ 114037.0 800000.0))) 0.0))
(check-sat)
