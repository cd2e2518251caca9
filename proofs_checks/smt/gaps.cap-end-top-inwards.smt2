; gaps.cap-end-top-inwards: a level e' that leaves p + k inwards, k the top vertex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (/ 29.0 125.0) x) (* (- (/ 667.0 2000.0)) y)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (- (/ 3.0 20.0)) x) (* (/ 87.0 125.0) y) (- (/ 20424109.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(check-sat)
