; separation.diameter: the diameter of K1 is below 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* (- 1.0) r) (/ 721313.0 4000000.0)) 0.0))
(assert (>= (* 1.0 r) 0.0))
(assert (>= (+ (* 4.0 r) (- 1.0)) 0.0))
(check-sat)
