; slanted.low-ratio-near: the leader beyond is at 1 or less, a gap beyond
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const e Real)
(assert (>= (* 1.0 e) 0.0))
(assert (>= (+ (* 1.0 D) (* 1.0 e)) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (- 1.0) e) 1.0) 0.0))
(assert (>= (+ (* 1.0 D) (- (/ 127323.0 500000.0))) 0.0))
(assert (> (+ (* (- 1.0) D D) (* 1.0 e e) (- (/ 1.0 2.0))) 0.0))
(check-sat)
