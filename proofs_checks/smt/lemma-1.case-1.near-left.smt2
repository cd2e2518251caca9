; lemma-1.case-1.near-left: the top side begins to the left of the foot of BL, so mfs(H) <= h
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const h Real)
(declare-const l Real)
(assert (>= (* 1.0 a) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (> (* 1.0 l) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (> (* (- 1.0) a) 0.0))
(check-sat)
