; p6-gap.above-45: (17/18)(L - 1/2) is above 45 from L = 49 on
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(assert (>= (+ (* 1.0 L) (- 49.0)) 0.0))
(assert (>= (+ (* (- (/ 17.0 18.0)) L) (/ 1637.0 36.0)) 0.0))
(check-sat)
