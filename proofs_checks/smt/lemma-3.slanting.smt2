; lemma-3.slanting: onto A E_i from 1/3 above or below E_i, and onto E_L C from (c,0), c - L = x
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- 1.0)) 0.0))
(assert (> (+ (* (- (/ 28.0 333.0)) x x) (/ 4.0 333.0)) 0.0))
(check-sat)
