; lemma-1.case-1.half-left-leg.beyond: in case 1 s is at distance l/2 or more from the left leg; the foot lies beyond the segment
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const h Real)
(declare-const l Real)
(assert (> (* 1.0 l) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (>= (* 1.0 a) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (> (+ (* (/ 1.0 2.0) a l) (* (- (/ 1.0 2.0)) h h)) 0.0))
(assert (> (* (- (/ 1.0 4.0)) h h) 0.0))
(check-sat)
