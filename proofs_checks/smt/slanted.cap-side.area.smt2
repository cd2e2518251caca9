; slanted.cap-side.area: a cap: its side edge, the corner s below the middle of K1: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (>= (- (/ 23693.0 250000.0)) 0.0))
(check-sat)
