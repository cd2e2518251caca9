; tube.corner-above: a' and b' are above L R: 1/4 - m - D > 0, as n >= 3/34
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const n Real)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 8.0 s s s s) (* (- 8.0) s s) 1.0) 0.0))
(assert (>= (+ (* 8.0 n) (- (/ 12.0 17.0))) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (- 1.0) n) (/ 1.0 4.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (/ 1.0 8.0) s) (- (/ 1.0 4.0))) 0.0))
(check-sat)
