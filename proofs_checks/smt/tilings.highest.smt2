; tilings.highest: an edge whose ends are no higher than y has no point above y
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const t Real)
(declare-const y Real)
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 y)) 0.0))
(assert (>= (+ (* (- 1.0) b) (* 1.0 y)) 0.0))
(assert (> (+ (* (- 1.0) a t) (* 1.0 b t) (* 1.0 a) (* (- 1.0) y)) 0.0))
(check-sat)
