; separation.octagon-6-4: vertex 6 of K1 and a point of the edge 4 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 9.0 400.0)) t t) (* (/ 9.0 200.0) t) (- (/ 7569.0 15625.0))) 0.0))
(check-sat)
