; section-1.apart-mfs: the mfs of the square with the edge is 3/2 or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(assert (> (* 1.0 e) 0.0))
(assert (>= (+ (* (- 1.0) e) 1.0) 0.0))
(assert (> (+ (* (/ 1.0 2.0) e) (- (/ 1.0 2.0))) 0.0))
(check-sat)
