; count.layers: h = ceil(n/2) gaps bring 20/9 h at most: n >= 10 bring n + 20/9 h <= 20/9 n
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const h Real)
(declare-const n Real)
(assert (>= (+ (* 1.0 n) (- 10.0)) 0.0))
(assert (>= (+ (* (- 2.0) h) (* 1.0 n) 1.0) 0.0))
(assert (>= (+ (* (- 9.0) L) (* 20.0 h) (* 9.0 n)) 0.0))
(assert (> (+ (* 9.0 L) (* (- 20.0) n)) 0.0))
(check-sat)
