; lemma-3.gap-chain-far: (u_j, E_i, E_i+1) onto u_j E_i+1: a = x_i - u_j, d = x_i+1 - x_i >= a
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const d Real)
(assert (>= (+ (* 1.0 a) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 d)) 0.0))
(assert (> (+ (* (/ 2.0 37.0) a d) (* (/ 1.0 37.0) a a) (* (- (/ 28.0 333.0)) d d) (/ 1.0 333.0)) 0.0))
(check-sat)
