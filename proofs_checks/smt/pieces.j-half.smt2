; pieces.j-half: e at f/2 or less
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(declare-const f Real)
(assert (>= (+ (* 1.0 e) (- 1.0)) 0.0))
(assert (> (* 1.0 f) 0.0))
(assert (>= (+ (* (- 2.0) e) (* 1.0 f)) 0.0))
(assert (> (+ (* 2.0 e f) (* (- 1.0) f f) (- (/ 4.0 25.0))) 0.0))
(check-sat)
