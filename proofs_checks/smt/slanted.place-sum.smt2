; slanted.place-sum: b + u, too
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const u Real)
(assert (> (* 1.0 b) 0.0))
(assert (>= (+ (* 1.0 u) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) u) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 b b) (* 1.0 u u) (- (/ 28079401.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) b) (* (- 1.0) u) (/ 177.0 250.0)) 0.0))
(check-sat)
