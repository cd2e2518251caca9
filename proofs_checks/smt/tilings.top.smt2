; tilings.top: top is above E: X times its height is X - 2 x/3 > X/3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const x Real)
(assert (> (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 X) (* (- 2.0) x)) 0.0))
(assert (>= (+ (* (- 2.0) X) (* 2.0 x)) 0.0))
(check-sat)
