; tube.sinks: they are together at most r/2 and a bit, SLACK
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const m Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 r) (- (/ 2999999997.0 34000000000.0))) 0.0))
(assert (>= (* 1.0 m) 0.0))
(assert (>= (+ (* (- 1.0) m m) (* (/ 1.0 4.0) r r) (/ 1.0 17179869184.0)) 0.0))
(assert (> (+ (* 1.0 m) (* (- (/ 1.0 2.0)) r) (- (/ 13.0 5637144576.0))) 0.0))
(check-sat)
