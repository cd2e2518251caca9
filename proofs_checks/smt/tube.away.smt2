; tube.away: 1/(4 sqrt 2) - sin(pi/8)/8 >= 0.1289
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 8.0 s s s s) (* (- 8.0) s s) 1.0) 0.0))
(assert (> (* 1.0 q) 0.0))
(assert (>= (+ (* 1.0 q q) (- 2.0)) 0.0))
(assert (> (+ (* (- 1.0) q) (* 1.0 s) (/ 1289.0 1250.0)) 0.0))
(check-sat)
