; columns-tube.first-near: the height over A-v0, 0.4701 at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 k) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) k) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 w) (- (/ 3.0 40.0))) 0.0))
(assert (> (+ (* (- 1.0) k w) (/ 1048323.0 100000000.0)) 0.0))
(check-sat)
