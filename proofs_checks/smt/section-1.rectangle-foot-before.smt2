; section-1.rectangle-foot-before: nor beyond it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- 3.0)) 0.0))
(assert (> (+ (* (- (/ 1.0 2.0)) r) (- (/ 1.0 2.0))) 0.0))
(check-sat)
