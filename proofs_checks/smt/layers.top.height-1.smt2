; layers.top.height-1: A, B and the last row: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const k Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) k) (* 1.0 x)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- 1.0) k) (* (- 1.0) x)) 0.0))
(assert (> (+ (* (- 1.0) D D k k) (* (- (/ 18.0 25.0)) D x) (* (/ 9.0 25.0) D D) (* (/ 9.0 25.0) k k) (* (/ 9.0 25.0) x x)) 0.0))
(check-sat)
