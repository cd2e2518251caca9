; slanted.cap-top.area: a cap: its top edge, the corner s below the middle of K1: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- (/ 3.0 20.0)) s) (- (/ 261.0 5000.0))) 0.0))
(check-sat)
