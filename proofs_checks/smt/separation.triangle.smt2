; separation.triangle: 2 (r - 0.4701) - g >= 0.0599 for an inradius r >= 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) r) (/ 12321.0 10000.0)) 0.0))
(check-sat)
