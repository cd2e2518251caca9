; slanted.low-top.height-2: (A, B, z): the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const T Real)
(declare-const e Real)
(assert (> (* 1.0 T) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 223.0 2320.0)) 0.0))
(assert (>= (+ (* 2.0 e) (- 1.0)) 0.0))
(assert (>= (+ (* 2.0 D) (* (- 2.0) e) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 D) (- 2.0)) 0.0))
(assert (> (+ (* 1.0 T T e e) (* (- (/ 16.0 25.0)) D D) (* (/ 16.0 25.0) T T)) 0.0))
(check-sat)
