; clean.third: apex (0,0), p = (x,h), q = (x + B,h), q r from the line of p: p is r/2 from that of q
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const B Real)
(declare-const h Real)
(declare-const r Real)
(declare-const x Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 1.0) r)) 0.0))
(assert (> (* 1.0 B) 0.0))
(assert (>= (+ (* 1.0 B B h h) (* (- 1.0) h h r r) (* (- 1.0) r r x x)) 0.0))
(assert (> (+ (* 2.0 B r r x) (* (- 4.0) B B h h) (* 1.0 B B r r) (* 1.0 h h r r) (* 1.0 r r x x)) 0.0))
(check-sat)
