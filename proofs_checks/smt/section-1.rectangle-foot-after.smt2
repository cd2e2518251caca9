; section-1.rectangle-foot-after: the foot of a midway vertex is not before the diagonal
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- 3.0)) 0.0))
(assert (> (+ (* (- (/ 1.0 4.0)) r r) (- (/ 3.0 4.0))) 0.0))
(check-sat)
