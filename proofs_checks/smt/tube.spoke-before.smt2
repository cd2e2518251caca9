; tube.spoke-before: a spoke that turns leaves a sine of 7/25: b, by >= 0, is farther than 957/5000 from the cone's side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const bx Real)
(declare-const by Real)
(assert (= (+ (* 1.0 bx bx) (* 1.0 by by) (- 1.0)) 0.0))
(assert (>= (* 1.0 by) 0.0))
(assert (>= (+ (* (- 1.0) by) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) bx) (/ 15.0 17.0)) 0.0))
(assert (>= (+ (* 1.0 bx) 1.0) 0.0))
(assert (> (+ (* 7.0 bx) (* (- 24.0) by) (/ 957.0 200.0)) 0.0))
(check-sat)
