; nesting.line: both ends of e' are g from the line: so is all of it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const t Real)
(assert (>= (+ (* 1.0 a) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* 1.0 b) (- (/ 29.0 125.0))) 0.0))
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (> (+ (* 1.0 a t) (* (- 1.0) b t) (* (- 1.0) a) (/ 29.0 125.0)) 0.0))
(check-sat)
