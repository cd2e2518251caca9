; separation.width-upper: and 2 n.k < 1 for the upper vertices
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (= (+ (* 1.0 x x) (* 1.0 y y) (- 1.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (/ 3.0 20.0) x) (* (/ 87.0 125.0) y) (- 1.0)) 0.0))
(check-sat)
