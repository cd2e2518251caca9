; separation.octagon-3-5: vertex 3 of K1 and a point of the edge 5 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 841.0 15625.0)) t t) (* (/ 3364.0 15625.0) t) (- (/ 1706273.0 4000000.0))) 0.0))
(check-sat)
