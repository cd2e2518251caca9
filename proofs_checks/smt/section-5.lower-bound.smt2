; section-5.lower-bound: N pieces of width d, d^2 <= 2 r, cover a side of length r: 2 N^2 >= r
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const N Real)
(declare-const d Real)
(declare-const r Real)
(assert (> (* 1.0 r) 0.0))
(assert (> (* 1.0 N) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d d) (* 2.0 r)) 0.0))
(assert (>= (+ (* 1.0 N d) (* (- 1.0) r)) 0.0))
(assert (> (+ (* (- 2.0) N N) (* 1.0 r)) 0.0))
(check-sat)
