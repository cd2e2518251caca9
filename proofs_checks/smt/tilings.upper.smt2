; tilings.upper: (A, E_L, C)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(assert (> (* 1.0 c) 0.0))
(assert (>= (* (- (/ 2.0 3.0)) c) 0.0))
(check-sat)
