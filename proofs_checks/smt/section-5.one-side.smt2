; section-5.one-side: no line is in both parts that the sides cut
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const f Real)
(declare-const u Real)
(declare-const w Real)
(assert (> (* 1.0 w) 0.0))
(assert (>= (* 1.0 f) 0.0))
(assert (>= (+ (* (/ 1.0 2.0) f w) (* (- 1.0) u)) 0.0))
(assert (>= (+ (* (- (/ 1.0 2.0)) f w) (* 1.0 u) (* (- (/ 1.0 2.0)) w)) 0.0))
(check-sat)
