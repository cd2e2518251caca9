; slanted.cap-side.height-3: a cap: its side edge, the corner s below the middle of K1: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 29.0 250.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 29.0 250.0)) 0.0))
(assert (> (+ (* (/ 841.0 390625.0) s s) (* (- (/ 24389.0 48828125.0)) s) (- (/ 1678416499.0 195312500000.0))) 0.0))
(check-sat)
