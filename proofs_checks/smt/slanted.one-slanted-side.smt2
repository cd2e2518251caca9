; slanted.one-slanted-side: so that side is so short
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* 2.0 x) (* (- 1.0) y)) 0.0))
(assert (> (+ (* (- (/ 31.0 25.0)) x y) (* (/ 1539.0 2500.0) y y)) 0.0))
(check-sat)
