; levels.halving: if at most q are left, at most q/2 are left after one more layer
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const m Real)
(declare-const q Real)
(declare-const up Real)
(assert (>= (+ (* (- 1.0) m) (* 1.0 q)) 0.0))
(assert (>= (+ (* 1.0 m) (* (- 2.0) up)) 0.0))
(assert (> (+ (* (- (/ 1.0 2.0)) q) (* 1.0 up)) 0.0))
(check-sat)
