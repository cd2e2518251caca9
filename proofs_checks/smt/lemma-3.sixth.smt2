; lemma-3.sixth: vertices on the last e are 1/6 or more below the upper side: 4 x >= L
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const v Real)
(assert (>= (+ (* 6.0 v) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) v v) (/ 1.0 37.0)) 0.0))
(check-sat)
