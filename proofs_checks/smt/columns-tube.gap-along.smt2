; columns-tube.gap-along: and goes 0.1103 at most along e
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (- (/ 129.0 100.0))) 0.0))
(assert (>= (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d s) (/ 711.0 5000.0)) 0.0))
(assert (> (+ (* 1.0 d) (- (/ 1103.0 10000.0))) 0.0))
(check-sat)
