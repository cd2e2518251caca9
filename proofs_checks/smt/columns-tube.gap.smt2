; columns-tube.gap: w is 0.0407 at least
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const w Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1547.0 1000.0)) 0.0))
(assert (>= (* 1.0 w) 0.0))
(assert (>= (+ (* 1.0 s s w w) (* 1.0 w w) (- (/ 9.0 1600.0))) 0.0))
(assert (> (+ (* (- 1.0) w) (/ 407.0 10000.0)) 0.0))
(check-sat)
