; rooms.corner: a leg of a level's height, not steeper than one that is trimmed, is longer than 0.075
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const t Real)
(declare-const x Real)
(assert (> (* 1.0 s) 0.0))
(assert (> (+ (* (- (/ 3.0 40.0)) t) (/ 57.0 1000.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (* 1.0 t)) 0.0))
(assert (> (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 s x) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) x) (/ 3.0 40.0)) 0.0))
(check-sat)
