; tube.edge-change: 45 degrees and an edge that turns leave more than 28: a change of 957/5000 at most does not reach it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const ex Real)
(declare-const ey Real)
(assert (>= (+ (* (- 1.0) ex ex) (* (- 1.0) ey ey) (/ 915849.0 25000000.0)) 0.0))
(assert (> (+ (* 8.0 ex) (* (- 15.0) ey) (- (/ 16269.0 5000.0))) 0.0))
(check-sat)
