; linear-size.corner: K <= H/2 + 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const K Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 H) (- 100.0)) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* 1.0 H H) (* (- 1.0) s s) 16.0) 0.0))
(assert (= (+ (* (- 1.0) H) (* 4.0 K) (* (- 1.0) s)) 0.0))
(assert (> (+ (* (- (/ 1.0 2.0)) H) (* 1.0 K) (- 1.0)) 0.0))
(check-sat)
