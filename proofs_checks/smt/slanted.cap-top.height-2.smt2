; slanted.cap-top.height-2: a cap: its top edge, the corner s below the middle of K1: the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (- (/ 127169.0 6250000.0)) s s) (* (- (/ 11063703.0 781250000.0)) s) (- (/ 59863221.0 24414062500.0))) 0.0))
(check-sat)
