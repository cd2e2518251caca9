; columns-tube.merged-wide: (A, v, v'), w >= 0.0459: the height over A-v, r long
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const r Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 k) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) k) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 w) (- (/ 459.0 10000.0))) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r r) (/ 22661901.0 100000000.0)) 0.0))
(assert (> (+ (* (- 1.0) k w) (* (/ 223.0 10000.0) r)) 0.0))
(check-sat)
