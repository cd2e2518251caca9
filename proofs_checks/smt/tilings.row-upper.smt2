; tilings.row-upper: (A, a, C)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const y Real)
(assert (> (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) y) 1.0) 0.0))
(assert (>= (+ (* 1.0 c y) (* (- 1.0) c)) 0.0))
(check-sat)
