; separation.obtuse: from 90 degrees on, |w0| <= |w0 - w1|
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const s Real)
(assert (= (+ (* 1.0 c c) (* 1.0 s s) (- 1.0)) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (* (- 1.0) c) 0.0))
(assert (>= (* 1.0 a) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (> (+ (* (- 1.0) b b c c) (* (- 1.0) b b s s) (* 2.0 a b c)) 0.0))
(check-sat)
