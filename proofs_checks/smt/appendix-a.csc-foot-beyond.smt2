; appendix-a.csc-foot-beyond: w1 acute, the foot of p2 beyond u: L >= 1/sin w1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const c Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) c k k k k) (* 1.0 L k k) (* (- 2.0) c k k) (* (- 1.0) L) (* (- 1.0) c)) 0.0))
(assert (>= (+ (* 2.0 c k) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) L k) (* 1.0 k k) 1.0) 0.0))
(check-sat)
