; linear-size.position: levels are r/2 from H and K at most: u >= H
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const K Real)
(declare-const r Real)
(declare-const u Real)
(assert (>= (+ (* 1.0 H) (- 100.0)) 0.0))
(assert (>= (+ (* (/ 1.0 2.0) H) (* (- 1.0) K) 1.0) 0.0))
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* (- 1.0) r) (/ 8.0 21.0)) 0.0))
(assert (>= (+ (* 1.0 r u) (* (- 1.0) H) (* 1.0 K) (* 1.0 r)) 0.0))
(assert (> (+ (* 1.0 H) (* (- 1.0) u)) 0.0))
(check-sat)
