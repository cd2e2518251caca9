; section-1.drawn-middle: if a and b are nearer than t, their middle is nearer than t/2 to both
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 t) 0.0))
(assert (> (+ (* 1.0 t t) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(assert (>= (+ (* (- (/ 1.0 4.0)) t t) (* (/ 1.0 4.0) x x) (* (/ 1.0 4.0) y y)) 0.0))
(check-sat)
