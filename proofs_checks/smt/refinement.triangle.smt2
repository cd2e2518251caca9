; refinement.triangle: 1/4 > sin(pi/8)/2 and 1/4 <= 1 - 1/(4 r) for 3 r >= 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const s Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 8.0 s s s s) (* (- 8.0) s s) 1.0) 0.0))
(assert (>= (+ (* 3.0 b) (- 1.0)) 0.0))
(assert (> (+ (* (- 12.0) b) 4.0) 0.0))
(check-sat)
