; appendix-a.z-left-of-p2: w1 acute: D = L - (k^2 - 1)/(2 k) >= 1/k
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const L Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 2.0 L k) (* (- 1.0) k k) (- 1.0)) 0.0))
(assert (= (+ (* 2.0 D k) (* (- 2.0) L k) (* 1.0 k k) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) D k) 1.0) 0.0))
(check-sat)
