; tube.fan-value: sin(pi/8)/(4 sqrt 2) >= 0.067
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* (- 8.0) s s s s) (* 8.0 s s) (- 1.0)) 0.0))
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* (- 1.0) q q) 2.0) 0.0))
(assert (> (+ (* (/ 67.0 250.0) q) (* (- 1.0) s)) 0.0))
(check-sat)
