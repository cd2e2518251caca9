; separation.octagon-0-2: vertex 0 of K1 and a point of the edge 2 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 9.0 400.0)) t t) (* (- (/ 2001.0 20000.0)) t) (- (/ 1216073.0 4000000.0))) 0.0))
(check-sat)
