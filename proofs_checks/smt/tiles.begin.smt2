; tiles.begin: e' begins at x <= 0.4247, and snaps: before the end of e
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const l Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 l) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) x) (/ 4247.0 10000.0)) 0.0))
(assert (>= (+ (* (- 2.0) d) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* 1.0 d) (* (- 1.0) l) (* 1.0 x)) 0.0))
(check-sat)
