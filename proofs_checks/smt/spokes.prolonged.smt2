; spokes.prolonged: at the tip of a prolonged edge, b <= 1/4
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(assert (>= (* 1.0 b) 0.0))
(assert (>= (+ (* (- 4.0) b) 1.0) 0.0))
(assert (> (+ (* 16.0 b b) (- 1.0)) 0.0))
(check-sat)
