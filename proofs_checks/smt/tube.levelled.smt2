; tube.levelled: a sine of 0.3315 or less has a cosine of 0.943 or more, and half of 2 n of it 9/10 n
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const e Real)
(assert (>= (+ (* 1.0 c c) (* 1.0 e e) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) e) (/ 663.0 2000.0)) 0.0))
(assert (>= (+ (* 1.0 e) (/ 663.0 2000.0)) 0.0))
(assert (> (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) c) (/ 943.0 1000.0)) 0.0))
(check-sat)
