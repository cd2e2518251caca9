; columns-tube.merged-base: the height from A
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 k) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) k) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 s) (/ 1547.0 1000.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1547.0 1000.0)) 0.0))
(assert (> (+ (* (- 1.0) k k) (* (/ 49729.0 100000000.0) s s) (/ 49729.0 100000000.0)) 0.0))
(check-sat)
