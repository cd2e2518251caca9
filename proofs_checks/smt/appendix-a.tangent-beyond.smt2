; appendix-a.tangent-beyond: w2 not acute: the foot of y1 is not beyond q2, because e_r is 1 or longer
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const d Real)
(declare-const j Real)
(assert (>= (* 1.0 j) 0.0))
(assert (>= (+ (* (- 1.0) j) 1.0) 0.0))
(assert (> (* 1.0 D) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* 1.0 d j j) (* 1.0 d) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) d j j j j) (* 1.0 D j j) (* (- 2.0) d j j) (* (- 1.0) D) (* (- 1.0) d) (* 2.0 j)) 0.0))
(check-sat)
