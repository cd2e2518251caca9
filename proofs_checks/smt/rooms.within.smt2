; rooms.within: v is within 0.075 of u, and p and w are between, p first: w is within 0.075 of p
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(declare-const u Real)
(declare-const v Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 u) (* (- 1.0) v) (/ 3.0 40.0)) 0.0))
(assert (>= (+ (* 1.0 p) (* (- 1.0) u)) 0.0))
(assert (>= (+ (* 1.0 v) (* (- 1.0) w)) 0.0))
(assert (> (+ (* (- 1.0) p) (* 1.0 w) (- (/ 3.0 40.0))) 0.0))
(check-sat)
