; gaps.longer-upper: the ends of a level e', with k - k1 = (3/20, 87/125), dy up to 29/125
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (/ 3.0 10.0) x) (* (/ 174.0 125.0) y) (- (/ 123271.0 250000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(check-sat)
