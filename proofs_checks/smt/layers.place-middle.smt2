; layers.place-middle: so is the middle
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const h Real)
(declare-const k Real)
(assert (>= (+ (* 1.0 D) (* (- 2.0) h)) 0.0))
(assert (>= (* 1.0 k) 0.0))
(assert (> (+ (* (- (/ 1.0 2.0)) D) (* 1.0 h) (* (- 1.0) k)) 0.0))
(check-sat)
