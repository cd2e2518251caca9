; tube.turn: 4 m = s/2 <= 0.1914
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 8.0 s s s s) (* (- 8.0) s s) 1.0) 0.0))
(assert (> (+ (* 1.0 s) (- (/ 957.0 2500.0))) 0.0))
(check-sat)
