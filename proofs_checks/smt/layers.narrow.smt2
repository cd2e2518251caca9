; layers.narrow: gaps of 2.17 f* or more, f* = t
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const W Real)
(declare-const t Real)
(assert (>= (+ (* 1.0 W) (* (- (/ 217.0 100.0)) t)) 0.0))
(assert (>= (+ (* 1.0 t) (- (/ 29.0 625.0))) 0.0))
(assert (> (+ (* (- 1.0) W) (/ 503.0 5000.0)) 0.0))
(check-sat)
