; clean.beyond: q on the level of p, B away: its foot on the line of an edge from p to (x,h) is on it, or q is r from the line
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const B Real)
(declare-const h Real)
(declare-const r Real)
(declare-const x Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 1.0) r)) 0.0))
(assert (> (* 1.0 x) 0.0))
(assert (> (* 1.0 B) 0.0))
(assert (> (+ (* 1.0 B x) (* (- 1.0) h h) (* (- 1.0) x x)) 0.0))
(assert (> (+ (* (- 1.0) B B h h) (* 1.0 h h r r) (* 1.0 r r x x)) 0.0))
(check-sat)
