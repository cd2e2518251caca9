; section-1.height: the points of the opposite side are h away or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 y) 0.0))
(assert (> (* (- 1.0) x x) 0.0))
(check-sat)
