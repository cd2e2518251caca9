; gaps.not-flat: an e' from p + k downwards to the side of p does not become level
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (> (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- (/ 29.0 125.0)) x) (* (/ 667.0 2000.0) y)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (- (/ 817.0 1000.0)) x) (* (/ 29.0 125.0) y) (- (/ 1883023.0 12500000.0))) 0.0))
(check-sat)
