; section-1.apart-worse: for every D some e makes 3/2 larger than D e
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const e Real)
(assert (> (* 1.0 D) 0.0))
(assert (> (* 1.0 e) 0.0))
(assert (>= (+ (* (- 1.0) D e) 1.0) 0.0))
(assert (>= (+ (* 1.0 D e) (- (/ 3.0 2.0))) 0.0))
(check-sat)
