; columns-tube.gap-rise: then e' rises by 0.1422 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 x) 0.0))
(assert (>= (* 1.0 q) 0.0))
(assert (>= (+ (* (- 1.0) q) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- (/ 129.0 100.0)) x) (* 1.0 y)) 0.0))
(assert (> (+ (* 1.0 q q x x) (* (- (/ 505521.0 25000000.0)) x x) (* (- (/ 505521.0 25000000.0)) y y)) 0.0))
(check-sat)
