; tilings.beside: (u, top, E), u beyond E
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const y Real)
(assert (> (* 1.0 d) 0.0))
(assert (> (+ (* 1.0 y) (- (/ 1.0 3.0))) 0.0))
(assert (>= (+ (* (- 1.0) d y) (* (/ 1.0 3.0) d)) 0.0))
(check-sat)
