; levels.snap: the nearest level is at most half a spacing away
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const j Real)
(declare-const t Real)
(assert (>= (+ (* (- 1.0) j) (* 1.0 t) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 j) (* (- 1.0) t) (/ 1.0 2.0)) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (> (+ (* (- 2.0) h h j t) (* 1.0 h h j j) (* 1.0 h h t t) (* (- (/ 1.0 4.0)) h h)) 0.0))
(check-sat)
