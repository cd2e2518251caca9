; levels.clearance: an edge from level j to level b >= j + 1, x to the side, is g long at least
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const j Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 b) (* (- 1.0) j) (- 1.0)) 0.0))
(assert (> (+ (* (/ 1682.0 15625.0) b j) (* (- (/ 841.0 15625.0)) b b) (* (- (/ 841.0 15625.0)) j j) (* (- 1.0) x x) (/ 841.0 15625.0)) 0.0))
(check-sat)
