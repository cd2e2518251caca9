; separation.octagon-3-4: vertex 3 of K1 and a point of the edge 4 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (/ 111447.0 500000.0) t) (- (/ 7569.0 15625.0))) 0.0))
(check-sat)
