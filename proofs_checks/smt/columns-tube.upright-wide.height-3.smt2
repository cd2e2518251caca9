; columns-tube.upright-wide.height-3: (foot, v above it, v0), v0 w before: the height from corner 3
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
(assert (> (+ (* (- 1.0) u u w w) (* (/ 49729.0 100000000.0) u u)) 0.0))
(check-sat)
