; rooms.two: two neighbours of Q on a chord on the same side of a vertex are not both within 0.075
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 x) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 599.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) x) (* (- 1.0) y) (/ 3.0 40.0)) 0.0))
(check-sat)
