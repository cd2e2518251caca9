; columns-tube.clean-along: 0.0688 long, rising by less than 0.0464: 0.0507 along e at least
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const r Real)
(assert (>= (* 1.0 d) 0.0))
(assert (>= (+ (* 1.0 r) (/ 29.0 625.0)) 0.0))
(assert (>= (+ (* (- 1.0) r) (/ 29.0 625.0)) 0.0))
(assert (>= (+ (* 1.0 d d) (* 1.0 r r) (- (/ 1849.0 390625.0))) 0.0))
(assert (> (+ (* (- 1.0) d) (/ 507.0 10000.0)) 0.0))
(check-sat)
