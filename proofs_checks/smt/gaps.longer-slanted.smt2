; gaps.longer-slanted: the ends of a level e', with k - k1 = (967/2000, 58/125), dy up to 29/125
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (* (/ 967.0 1000.0) x) (* (/ 116.0 125.0) y) (- (/ 2203727.0 4000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(check-sat)
