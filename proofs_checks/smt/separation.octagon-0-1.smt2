; separation.octagon-0-1: vertex 0 of K1 and a point of the edge 1 after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* (- (/ 132037.0 800000.0)) t t) (* (- (/ 1682.0 15625.0)) t) (- (/ 7831.0 250000.0))) 0.0))
(check-sat)
