; appendix-a.triangle-large: for r >= 1/2: |e'| >= sqrt(3)/6
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const Z Real)
(declare-const e Real)
(declare-const r Real)
(assert (> (* 1.0 e) 0.0))
(assert (> (* 1.0 Z) 0.0))
(assert (> (* 1.0 r) 0.0))
(assert (> (+ (* 1.0 e) (* (- 2.0) r)) 0.0))
(assert (>= (+ (* 2.0 r) (- 1.0)) 0.0))
(assert (> (+ (* (- 48.0) e e r r) (* 24.0 e e r) (* (- 3.0) e e) (* 4.0 r r)) 0.0))
(check-sat)
