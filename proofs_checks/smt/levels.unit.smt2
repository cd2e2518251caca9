; levels.unit: a whole number of 24 bits below a root is less by a millionth at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const N Real)
(declare-const k Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (+ (* 1.0 k k) (* (- 1.0) N) (* (/ 1.0 4194304.0) k) (/ 1.0 70368744177664.0)) 0.0))
(assert (> (+ (* (- (/ 1000002000001.0 1000000000000.0)) k k) (* 1.0 N)) 0.0))
(check-sat)
