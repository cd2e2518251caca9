; pieces.n3.height-2: (A, E, a), a on A-f beyond f/2: the height from E
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(declare-const f Real)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 e) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) e) (* 1.0 f)) 0.0))
(assert (>= (+ (* (- 2.0) e f) (* 1.0 f f) (/ 4.0 25.0)) 0.0))
(assert (> (+ (* 25.0 f f t t) (* 32.0 e f) (* (- 16.0) e e) (* (- 16.0) f f) (* 16.0 t t)) 0.0))
(check-sat)
