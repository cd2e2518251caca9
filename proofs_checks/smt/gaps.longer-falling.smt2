; gaps.longer-falling: the ends of a level e', with k - k1 = (817/1000, 29/125), dy up to 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 y) (/ 29.0 125.0)) 0.0))
(assert (>= (* (- 1.0) y) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (/ 817.0 500.0) x) (* (/ 58.0 125.0) y) (- (/ 278687.0 1000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(check-sat)
