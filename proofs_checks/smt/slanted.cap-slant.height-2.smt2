; slanted.cap-slant.height-2: a cap: its slant edge, the corner s below the middle of K1: the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (- (/ 10906929.0 100000000.0)) s s) (* (- (/ 1093975323.0 12500000000.0)) s) (- (/ 109613720601.0 6250000000000.0))) 0.0))
(check-sat)
