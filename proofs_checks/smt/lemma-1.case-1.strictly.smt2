; lemma-1.case-1.strictly: in case 1 s is farther than l/2 from the right leg
; sat: false
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const h Real)
(declare-const l Real)
(assert (> (* 1.0 l) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (>= (* 1.0 a) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (>= (+ (* (- 2.0) b h h l) (* (- 1.0) b b h h) (* 1.0 b b l l)) 0.0))
(check-sat)
