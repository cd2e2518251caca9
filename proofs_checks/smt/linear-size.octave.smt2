; linear-size.octave: one more node is at most 4 times as far
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 q) (* (- 1.0) x)) 0.0))
(assert (>= (+ (* 4.0 x) (* (- 1.0) y)) 0.0))
(assert (> (+ (* (- 4.0) q) (* 1.0 y)) 0.0))
(check-sat)
