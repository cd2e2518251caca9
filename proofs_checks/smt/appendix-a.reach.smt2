; appendix-a.reach: w1 acute: t1 is at most 1/4 beyond z
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) k k) (* (- 1.0) k) 2.0) 0.0))
(check-sat)
