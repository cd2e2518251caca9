; separation.octagon-6-3: vertex 6 of K1 and a point of the edge 3 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (/ 214397.0 2000000.0) t) (- (/ 1706273.0 4000000.0))) 0.0))
(check-sat)
