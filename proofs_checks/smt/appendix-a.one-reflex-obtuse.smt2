; appendix-a.one-reflex-obtuse: one reflex end, w1 not acute: |e'| >= 3/4
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const k Real)
(assert (>= (* 1.0 k) 0.0))
(assert (>= (+ (* (- 1.0) k) 1.0) 0.0))
(assert (>= (+ (* 1.0 L) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) L) (* (/ 1.0 4.0) k) (/ 3.0 4.0)) 0.0))
(check-sat)
