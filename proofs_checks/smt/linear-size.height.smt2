; linear-size.height: (0,0) is 4 or more from the line of the opposite side: 64 H^2 >= 16 (16 + H^2)
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(assert (>= (+ (* 1.0 H) (- 100.0)) 0.0))
(assert (> (+ (* (- 48.0) H H) 256.0) 0.0))
(check-sat)
