; tall.least-gap: a gap of r at least, along B
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const G Real)
(declare-const c Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- (/ 29997.0 340000.0))) 0.0))
(assert (>= (+ (* 1.0 c) (- (/ 943.0 1000.0))) 0.0))
(assert (>= (+ (* (- 1.0) c r) (* 1.0 G)) 0.0))
(assert (> (+ (* (- 1.0) G) (/ 83.0 1000.0)) 0.0))
(check-sat)
