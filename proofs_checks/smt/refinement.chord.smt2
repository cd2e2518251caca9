; refinement.chord: a chord of 90 degrees or less keeps 1/(4 sqrt 2) from the centre
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const mx Real)
(declare-const my Real)
(declare-const t Real)
(assert (= (+ (* 16.0 mx mx) (* 16.0 my my) (- 1.0)) 0.0))
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 1.0) 0.0))
(assert (>= (* 1.0 mx) 0.0))
(assert (> (+ (* (- 32.0) mx mx t t) (* (- 32.0) my my t t) (* 16.0 mx t t) (* (- 16.0) mx t) (* (- 2.0) t t) (* 4.0 t) (- 1.0)) 0.0))
(check-sat)
