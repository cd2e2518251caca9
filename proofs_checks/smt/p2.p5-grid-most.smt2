; p2.p5-grid-most: the end z of a chord is on the level y = j g of its vertex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const g Real)
(declare-const j Real)
(declare-const y Real)
(declare-const z Real)
(assert (= (+ (* (- 1.0) g j) (* 1.0 y)) 0.0))
(assert (= (+ (* (- 1.0) y) (* 1.0 z)) 0.0))
(assert (> (+ (* (- 1.0) g j) (* 1.0 z)) 0.0))
(check-sat)
