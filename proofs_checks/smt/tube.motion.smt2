; tube.motion: r/2 and 2^-17 to the side are together at most n (1/2 + 10^-8), r <= n, n >= 3/34
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const n Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 n) (- (/ 3.0 34.0))) 0.0))
(assert (>= (+ (* 1.0 n) (* (- 1.0) r)) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (> (+ (* (- (/ 2500000100000001.0 10000000000000000.0)) n n) (* (/ 1.0 4.0) r r) (/ 1.0 17179869184.0)) 0.0))
(check-sat)
