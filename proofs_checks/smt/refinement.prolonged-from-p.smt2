; refinement.prolonged-from-p: a point b > 0 beyond the end of the arc is farther than 1/4 from v
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(assert (> (* 1.0 b) 0.0))
(assert (>= (* (- 16.0) b b) 0.0))
(check-sat)
