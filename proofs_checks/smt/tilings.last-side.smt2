; tilings.last-side: (c, C, E_L)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const x Real)
(assert (> (+ (* 1.0 c) (* (- 1.0) x)) 0.0))
(assert (>= (+ (* (- 1.0) c) (* 1.0 x)) 0.0))
(check-sat)
