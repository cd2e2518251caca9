; tilings.fan: (A, E, top), top above E
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 x) 0.0))
(assert (> (+ (* 1.0 y) (- (/ 1.0 3.0))) 0.0))
(assert (>= (+ (* (- 1.0) x y) (* (/ 1.0 3.0) x)) 0.0))
(check-sat)
