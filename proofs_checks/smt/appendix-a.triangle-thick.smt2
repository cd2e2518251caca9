; appendix-a.triangle-thick: e > 2 r
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const Z Real)
(declare-const e Real)
(declare-const r Real)
(assert (> (* 1.0 e) 0.0))
(assert (> (* 1.0 Z) 0.0))
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 Z e e) (* (- 4.0) Z r r) (* (- 4.0) e r r)) 0.0))
(assert (>= (+ (* (- 1.0) e) (* 2.0 r)) 0.0))
(check-sat)
