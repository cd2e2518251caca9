; separation.width: K1 is less than 1 wide: 2 n.k < 1 for |n| = 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (= (+ (* 1.0 x x) (* 1.0 y y) (- 1.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (/ 817.0 1000.0) x) (* (/ 29.0 125.0) y) (- 1.0)) 0.0))
(check-sat)
