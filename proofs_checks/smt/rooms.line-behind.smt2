; rooms.line-behind: e' begins before p and ends beyond: its line is above p
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const w Real)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* (- 1.0) x) 0.0))
(assert (> (* 1.0 z) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 w) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 w x) (* (- 1.0) y z)) 0.0))
(check-sat)
