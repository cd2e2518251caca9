; tube.side-low: a is 1/21 from L a'
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const u Real)
(declare-const y Real)
(assert (> (* 1.0 u) 0.0))
(assert (>= (+ (* 1.0 u) (* (- 1.0) y)) 0.0))
(assert (>= (+ (* 1.0 u) (* 1.0 y)) 0.0))
(assert (>= (+ (* 1.0 u u) (* 1.0 y y) (- (/ 1661521.0 100000000.0))) 0.0))
(assert (>= (+ (* 1.0 D) (- (/ 619047.0 4000000.0))) 0.0))
(assert (> (+ (* (- 1.0) D D u u) (* (/ 2.0 441.0) D y) (* (/ 1.0 441.0) D D) (* (/ 1.0 441.0) u u) (* (/ 1.0 441.0) y y)) 0.0))
(check-sat)
