; slanted.cap-top.height-1: a cap: its top edge, the corner s below the middle of K1: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (- (/ 9.0 400.0)) s s) (* (- (/ 783.0 50000.0)) s) (- (/ 1672749.0 625000000.0))) 0.0))
(check-sat)
