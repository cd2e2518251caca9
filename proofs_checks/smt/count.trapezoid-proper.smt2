; count.trapezoid-proper: d feet of T-vertices, r >= 1 others with r + 1 gaps: not above the charges
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const r Real)
(assert (>= (* 1.0 d) 0.0))
(assert (>= (+ (* 1.0 r) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) r) 1.0) 0.0))
(check-sat)
