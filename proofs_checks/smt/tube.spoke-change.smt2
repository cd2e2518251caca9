; tube.spoke-change: a spoke that turns leaves a sine of 7/25: a change of 957/5000 at most does not reach it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const ex Real)
(declare-const ey Real)
(assert (>= (+ (* (- 1.0) ex ex) (* (- 1.0) ey ey) (/ 915849.0 25000000.0)) 0.0))
(assert (> (+ (* 7.0 ex) (* (- 24.0) ey) (- (/ 957.0 200.0))) 0.0))
(check-sat)
