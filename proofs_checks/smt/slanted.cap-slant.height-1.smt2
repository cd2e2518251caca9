; slanted.cap-slant.height-1: a cap: its slant edge, the corner s below the middle of K1: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (- (/ 444889.0 4000000.0)) s s) (* (- (/ 44508243.0 500000000.0)) s) (- (/ 21819624737.0 1250000000000.0))) 0.0))
(check-sat)
