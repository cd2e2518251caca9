; tall.lean-top-onto-t-u: its height onto t u, if Q <= 0.2147
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const G Real)
(declare-const Q Real)
(declare-const c Real)
(assert (>= (* 1.0 Q) 0.0))
(assert (>= (+ (* (- 1.0) Q) 1.0) 0.0))
(assert (>= (* 1.0 G) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (>= (+ (* (- 1.0) c) 1.0) 0.0))
(assert (>= (+ (* (- 1.0) Q) (/ 2147.0 10000.0)) 0.0))
(assert (> (+ (* (/ 59.0 500.0) Q c) (* (/ 13341.0 250000.0) c) (- (/ 125997.0 1250000.0))) 0.0))
(check-sat)
