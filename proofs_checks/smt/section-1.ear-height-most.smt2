; section-1.ear-height-most: the height of an ear is 1 - c, at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const s Real)
(assert (= (+ (* 1.0 c c) (* 1.0 s s) (- 1.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) c) 1.0) 0.0))
(assert (> 0.0 0.0))
(check-sat)
