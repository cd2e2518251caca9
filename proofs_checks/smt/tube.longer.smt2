; tube.longer: two spacings of n less 10^-9 are more than the height 1/4 - n, n >= 3/34
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const n Real)
(declare-const r Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 n) (- (/ 3.0 34.0))) 0.0))
(assert (>= (+ (* (- (/ 999999999.0 1000000000.0)) n) (* 1.0 r)) 0.0))
(assert (>= (+ (* (- 2.0) r) (* 1.0 w)) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (- 1.0) n) (/ 1.0 4.0)) 0.0))
(assert (> (* 1.0 D) 0.0))
(assert (> (+ (* 1.0 D) (* (- 1.0) w)) 0.0))
(check-sat)
