; columns-tube.slope-end: with chord ends it rises by two levels or more: |s| is 0.36 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* 1.0 y) 0.0))
(assert (>= (* 1.0 z) 0.0))
(assert (>= (+ (* 1.0 y) (* (- 1.0) z) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (* 1.0 z) (/ 29.0 125.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 z) (- (/ 58.0 125.0))) 0.0))
(assert (> (+ (* (- (/ 9.0 25.0)) x x) (* (- (/ 9.0 25.0)) y z) (* (/ 29.0 125.0) x)) 0.0))
(check-sat)
