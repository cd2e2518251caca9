; p2.both-reflex-most: ends of e' above the ends of e, (0,0) and (L,0): the same length
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const u Real)
(declare-const v Real)
(assert (> (* 1.0 L) 0.0))
(assert (= (* 1.0 L u) 0.0))
(assert (= (+ (* 1.0 L v) (* (- 1.0) L L)) 0.0))
(assert (> (+ (* (- 1.0) L u) (* 1.0 L v) (* (- 1.0) L L)) 0.0))
(check-sat)
