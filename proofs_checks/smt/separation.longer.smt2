; separation.longer: where the foot is beyond e1, e0 is longer
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(assert (>= (* 1.0 c) 0.0))
(assert (>= (+ (* (- 1.0) c) 1.0) 0.0))
(assert (> (* 1.0 a) 0.0))
(assert (> (* 1.0 b) 0.0))
(assert (> (+ (* 1.0 b c) (* (- 1.0) a)) 0.0))
(assert (>= (+ (* 1.0 a) (* (- 1.0) b)) 0.0))
(check-sat)
