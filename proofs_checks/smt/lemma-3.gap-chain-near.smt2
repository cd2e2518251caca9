; lemma-3.gap-chain-near: onto u_j E_i
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const d Real)
(assert (>= (+ (* 1.0 a) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 d)) 0.0))
(assert (> (+ (* (/ 1.0 37.0) a a) (* (- (/ 1.0 9.0)) d d) (/ 1.0 333.0)) 0.0))
(check-sat)
