; layers.place: an apex is h - k from A, or more: W is the inset, x the right end of its gap
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const h Real)
(declare-const k Real)
(declare-const x Real)
(assert (>= (+ (* (- 1.0) h) (* 1.0 x)) 0.0))
(assert (>= (+ (* (- 1.0) W) (* 1.0 k)) 0.0))
(assert (> (+ (* 1.0 W) (* 1.0 h) (* (- 1.0) k) (* (- 1.0) x)) 0.0))
(check-sat)
