; gaps.edge-side: the ends of a level e', where k - k1 is the side vertex of 2 K1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (/ 817.0 500.0) x) (* (/ 58.0 125.0) y) (- (/ 278687.0 1000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 43.0 625.0)) 0.0))
(check-sat)
