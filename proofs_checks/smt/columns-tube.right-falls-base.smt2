; columns-tube.right-falls-base: the height from A
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1547.0 1000.0)) 0.0))
(assert (> (+ (* (- 1.0) s s x x) (* (- 2.0) s x y) (* (/ 49729.0 100000000.0) s s) (* (- 1.0) y y) (/ 49729.0 100000000.0)) 0.0))
(check-sat)
