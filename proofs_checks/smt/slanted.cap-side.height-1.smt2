; slanted.cap-side.height-1: a cap: its side edge, the corner s below the middle of K1: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (- (/ 13852892289.0 1562500000000.0)) 0.0))
(check-sat)
