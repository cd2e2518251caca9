; section-1.rectangle-exact-most: and is 1/sqrt(((r + 1)/2)^2 + 1), at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- 3.0)) 0.0))
(assert (> 0.0 0.0))
(check-sat)
