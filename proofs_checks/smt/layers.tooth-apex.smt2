; layers.tooth-apex: a tooth, d deep: the height from its apex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const m Real)
(assert (>= (+ (* 1.0 m) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) m) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) d d) (* (/ 9.0 25.0) m m) (/ 9.0 25.0)) 0.0))
(check-sat)
