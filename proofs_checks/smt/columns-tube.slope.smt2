; columns-tube.slope: e' with feet: |s| is 1.547 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* 1.0 y) 0.0))
(assert (>= (* 1.0 z) 0.0))
(assert (>= (+ (* 1.0 y) (* (- 1.0) z) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 1.0) y) (* 1.0 z) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 x) (- (/ 3.0 20.0))) 0.0))
(assert (> (+ (* (- (/ 1547.0 1000.0)) x x) (* (- (/ 1547.0 1000.0)) y z) (* (/ 29.0 125.0) x)) 0.0))
(check-sat)
