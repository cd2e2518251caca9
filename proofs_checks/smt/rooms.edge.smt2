; rooms.edge: from w to w1 by an e' before it snaps: it is 0.15 long
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const m Real)
(assert (>= (+ (* 1.0 m) (- (/ 753.0 5000.0))) 0.0))
(assert (> (+ (* (- 1.0) m) (/ 3.0 20.0)) 0.0))
(check-sat)
