; slanted.cap-slant.height-3: a cap: its slant edge, the corner s below the middle of K1: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (- (/ 10906929.0 100000000.0)) s s) (* (- (/ 1106462491.0 12500000000.0)) s) (- (/ 108892489093.0 6250000000000.0))) 0.0))
(check-sat)
