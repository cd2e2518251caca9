; tube.spacing: points on different levels are r apart
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r) (* 1.0 y)) 0.0))
(assert (> (+ (* 1.0 r r) (* (- 1.0) x x) (* (- 1.0) y y)) 0.0))
(check-sat)
