; separation.octagon-2-1: vertex 2 of K1 and a point of the edge 1 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (- (/ 2001.0 20000.0)) t)) 0.0))
(check-sat)
