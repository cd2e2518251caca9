; section-1.table-regular: n/4 >= (n + r)/6 for r = 2/side, n side >= 5
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const n Real)
(declare-const r Real)
(declare-const side Real)
(assert (> (* 1.0 n) 0.0))
(assert (> (* 1.0 side) 0.0))
(assert (>= (+ (* 1.0 n side) (- 5.0)) 0.0))
(assert (= (+ (* 1.0 r side) (- 2.0)) 0.0))
(assert (> (+ (* (- 2.0) n) (* 4.0 r)) 0.0))
(check-sat)
