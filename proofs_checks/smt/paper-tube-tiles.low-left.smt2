; paper-tube-tiles.low-left: (a', L, s) turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const k Real)
(declare-const p Real)
(declare-const v Real)
(assert (>= (+ (* 1.0 p) (- (/ 5.0 4.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 9.0 10.0))) 0.0))
(assert (>= (+ (* 1.0 k) (- (/ 49999999.0 100000000.0))) 0.0))
(assert (>= (+ (* (- 1.0) v) (/ 1.0 4.0)) 0.0))
(assert (>= (+ (* 1.0 v) (- (/ 4194303.0 16777216.0))) 0.0))
(assert (>= (+ (* (- 1.0) d k) (* (- 1.0) k p) (* 1.0 p v)) 0.0))
(check-sat)
