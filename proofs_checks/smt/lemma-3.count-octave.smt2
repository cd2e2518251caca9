; lemma-3.count-octave: x_i >= i goes on: x_i+1 >= 2 x_i >= i + 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 x) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) k) (* 1.0 x)) 0.0))
(assert (>= (+ (* (- 2.0) x) (* 1.0 y)) 0.0))
(assert (> (+ (* 1.0 k) (* (- 1.0) y) 1.0) 0.0))
(check-sat)
