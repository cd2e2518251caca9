; section-1.table-rectangle: with k = n - 3 midway vertices and one more, r >= 2 n: X >= (n + r)/6
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const n Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 n) (- 6.0)) 0.0))
(assert (>= (+ (* (- 2.0) n) (* 1.0 r)) 0.0))
(assert (>= (+ (* 2.0 X) (* 1.0 n) (* (- 1.0) r) (- 7.0)) 0.0))
(assert (> (+ (* (- 6.0) X) (* 1.0 n) (* 1.0 r)) 0.0))
(check-sat)
