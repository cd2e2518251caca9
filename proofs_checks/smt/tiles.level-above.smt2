; tiles.level-above: the same upside down: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const a Real)
(assert (> (* 1.0 a) 0.0))
(assert (> (* 1.0 H) 0.0))
(assert (>= (* (- 1.0) H a) 0.0))
(check-sat)
