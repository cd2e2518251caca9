; columns-legs.end-leg: the height over the leg, p from its line
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(assert (>= (+ (* 1.0 p) (- (/ 9.0 200.0))) 0.0))
(assert (> (+ (* (- 1.0) p) (/ 223.0 10000.0)) 0.0))
(check-sat)
