; slanted.low-depth: an apex, at most h (4/5 - s^2/10) high, below e', y high
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const r Real)
(declare-const s Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 h) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) h) (* 1.0 y)) 0.0))
(assert (>= (+ (* (- (/ 1.0 10.0)) h s s) (* (/ 4.0 5.0) h) (* (- 1.0) r)) 0.0))
(assert (> (+ (* (/ 29.0 1250.0) s s) (* 1.0 r) (* (- 1.0) y) (/ 29.0 625.0)) 0.0))
(check-sat)
