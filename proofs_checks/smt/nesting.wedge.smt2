; nesting.wedge: n.x >= g and n.c <= 0 for |n| = 1: x and c are g apart, (x, y) being from c to x
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const nx Real)
(declare-const ny Real)
(declare-const x Real)
(declare-const y Real)
(assert (= (+ (* 1.0 nx nx) (* 1.0 ny ny) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 nx x) (* 1.0 ny y) (- (/ 29.0 125.0))) 0.0))
(assert (> (+ (* (- 1.0) x x) (* (- 1.0) y y) (/ 841.0 15625.0)) 0.0))
(check-sat)
