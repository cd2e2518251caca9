; offset.reaches: the side vertices of K2 reach less far
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r r) (/ 176557.0 800000.0)) 0.0))
(assert (> (+ (* 1.0 r r) (- (/ 220921.0 1000000.0))) 0.0))
(check-sat)
