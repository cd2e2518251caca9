; columns-tube.gap-up: e' is made steeper: neighbours are as far apart along e as sideways
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(declare-const z Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (* 1.0 y) 0.0))
(assert (>= (+ (* (- 1.0) y) (* 1.0 z)) 0.0))
(assert (> (+ (* (- 2.0) x x y z) (* 1.0 x x y y) (* (- 1.0) y y z z)) 0.0))
(check-sat)
