; appendix-a.tangent-before: w2 not acute, the foot of y1 before e_r: D >= j
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const j Real)
(assert (>= (* 1.0 j) 0.0))
(assert (>= (+ (* (- 1.0) j) 1.0) 0.0))
(assert (> (* 1.0 D) 0.0))
(assert (>= (+ (* (- 1.0) D j j) (* 1.0 D) (* (- 2.0) j)) 0.0))
(assert (> (+ (* (- 1.0) D) (* 1.0 j)) 0.0))
(check-sat)
