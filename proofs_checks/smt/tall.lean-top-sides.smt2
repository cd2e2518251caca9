; tall.lean-top-sides: its sides t s and u s, which is shorter, are SIDE at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const G Real)
(declare-const Q Real)
(declare-const h Real)
(assert (>= (* 1.0 Q) 0.0))
(assert (>= (* 1.0 G) 0.0))
(assert (>= (+ (* (- 1.0) G) (/ 2977.0 10000.0)) 0.0))
(assert (>= (+ (* (- 1.0) G) (* (- 1.0) Q) (/ 2977.0 10000.0)) 0.0))
(assert (>= (* 1.0 h) 0.0))
(assert (>= (+ (* (- 1.0) h) (/ 1727.0 10000.0)) 0.0))
(assert (> (+ (* 1.0 G Q) (* 1.0 G G) (* (/ 1.0 4.0) Q Q) (* 1.0 h h) (- (/ 4761.0 40000.0))) 0.0))
(check-sat)
