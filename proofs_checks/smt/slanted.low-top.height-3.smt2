; slanted.low-top.height-3: (A, B, z): the height from corner 3
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
(assert (> (+ (* 1.0 D D T T) (* (- (/ 16.0 25.0)) D D)) 0.0))
(check-sat)
