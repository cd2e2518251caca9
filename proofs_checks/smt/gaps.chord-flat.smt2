; gaps.chord-flat: c is 1 - rho from p, at most 58/125 above or below, v is 3/40 beside p
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (- 1.0) y) (/ 58.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (- (/ 28079401.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) x) (/ 9.0 40.0)) 0.0))
(check-sat)
