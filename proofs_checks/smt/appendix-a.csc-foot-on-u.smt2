; appendix-a.csc-foot-on-u: w1 acute, the foot of p2 on u, at distance 1 or more: L >= 1/sin w1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (* 1.0 L) 0.0))
(assert (>= (+ (* 4.0 L L k k) (* (- 1.0) k k k k) (* (- 2.0) k k) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) L k) (* 1.0 k k) 1.0) 0.0))
(check-sat)
