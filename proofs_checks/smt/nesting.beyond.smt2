; nesting.beyond: p + L v, L >= 1, is L times as far from p + w as v is from w/L, which is on the edge
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 x x) (* 1.0 y y) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) L L x x) (* (- 1.0) L L y y) 1.0) 0.0))
(check-sat)
