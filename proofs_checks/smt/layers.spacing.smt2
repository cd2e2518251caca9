; layers.spacing: 3/5 q is above 0.0223
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const k Real)
(assert (>= (+ (* 1.0 k) (- (/ 503.0 10000.0))) 0.0))
(assert (> (+ (* (- (/ 3.0 5.0)) k) (/ 223.0 10000.0)) 0.0))
(check-sat)
