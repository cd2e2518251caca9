; rooms.feet-lower: two feet l apart, and the second vertex: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const w Real)
(declare-const y Real)
(assert (> (* 1.0 l) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 w) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* (- 1.0) l w) 0.0))
(check-sat)
