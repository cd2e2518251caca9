; columns-tube.upright-wide.area: (foot, v above it, v0), v0 w before: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const t Real)
(declare-const u Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 t) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 u) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) u) (/ 4701.0 10000.0)) 0.0))
(assert (>= (+ (* 1.0 w) (- (/ 459.0 10000.0))) 0.0))
(assert (>= (* (- 1.0) u w) 0.0))
(check-sat)
