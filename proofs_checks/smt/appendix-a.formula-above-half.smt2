; appendix-a.formula-above-half: 1/(2 sin w1) >= 1/2
; unsat proves it
(set-logic QF_NRA)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) k k) (- 1.0) (* 2.0 k)) 0.0))
(check-sat)
