; lemma-3.last-obtuse: the angle A E_L C is not acute: (-L,2/3).(c - L,2/3) <= 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const xi Real)
(assert (>= (+ (* 1.0 xi) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (> (+ (* (- 1.0) d xi) (/ 4.0 9.0)) 0.0))
(check-sat)
