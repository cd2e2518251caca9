; slanted.one-below.area: (A, B, z): counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 y) (- (/ 87.0 1250.0))) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 x) (/ 3.0 25.0)) 0.0))
(assert (>= (+ (* 1.0 L) (* (- 1.0) x) (/ 3.0 25.0)) 0.0))
(assert (>= (* (- 1.0) L y) 0.0))
(check-sat)
