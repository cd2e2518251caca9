; appendix-a.formula-above-half: 1/(2 sin w1) >= 1/2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) k k) (* 2.0 k) (- 1.0)) 0.0))
(check-sat)
