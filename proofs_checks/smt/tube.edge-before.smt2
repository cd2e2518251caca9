; tube.edge-before: 45 degrees and an edge that turns leave more than 28: b, by >= 0, is farther than 957/5000 from the cone's side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const bx Real)
(declare-const by Real)
(assert (= (+ (* 1.0 bx bx) (* 1.0 by by) (- 1.0)) 0.0))
(assert (>= (* 1.0 by) 0.0))
(assert (>= (+ (* (- 1.0) by) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) bx) (/ 442.0 625.0)) 0.0))
(assert (>= (+ (* 1.0 bx) 1.0) 0.0))
(assert (> (+ (* 8.0 bx) (* (- 15.0) by) (/ 16269.0 5000.0)) 0.0))
(check-sat)
