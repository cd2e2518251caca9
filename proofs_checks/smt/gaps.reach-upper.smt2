; gaps.reach-upper: its upper vertices reach less far
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* (- 1.0) x x) (/ 126729.0 1000000.0)) 0.0))
(assert (> (+ (* 1.0 x x) (- (/ 721313.0 4000000.0))) 0.0))
(check-sat)
