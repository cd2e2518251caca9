; slanted.one-far-side: the height over another side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 y) (- (/ 29.0 250.0))) 0.0))
(assert (>= (+ (* 1.0 p) (- (/ 43.0 625.0))) 0.0))
(assert (> (+ (* (- 1.0) p p y y) (* (/ 841.0 1562500.0) p p) (* (/ 841.0 390625.0) y y)) 0.0))
(check-sat)
