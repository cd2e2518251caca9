; pieces.j-near: e nearer than 1/5 to the line of h, below that of f
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(declare-const f Real)
(declare-const h Real)
(assert (>= (+ (* 1.0 e) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) e) (* 1.0 f)) 0.0))
(assert (> (+ (* (- 1.0) f) (* 1.0 h)) 0.0))
(assert (>= (+ (* (- 2.0) f h) (* 1.0 h h) (/ 4.0 25.0)) 0.0))
(assert (> (+ (* 32.0 e e f h) (* (- 16.0) e e f f) (* (- 16.0) e e h h) (* 1.0 f f h h) (* (/ 16.0 25.0) f f)) 0.0))
(assert (> (+ (* 2.0 e f) (* (- 1.0) f f) (- (/ 4.0 25.0))) 0.0))
(check-sat)
