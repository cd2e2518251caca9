; tiles.between-upper-left: vertices x apart, feet c and d below: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const x Real)
(assert (> (* 1.0 x) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (> (* 1.0 c) 0.0))
(assert (>= (* (- 1.0) d x) 0.0))
(check-sat)
