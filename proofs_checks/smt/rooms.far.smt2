; rooms.far: a foot h before the far level, on a leg of slope 0.057/r, and the corner there
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const r Real)
(assert (> (+ (* 1.0 r) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 61.0 1000.0))) 0.0))
(assert (> (+ (* (- 1.0) h h r r) (* (- (/ 3249.0 1000000.0)) h h) (/ 29241.0 1600000000.0)) 0.0))
(check-sat)
