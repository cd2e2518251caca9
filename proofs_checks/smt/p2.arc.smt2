; p2.arc: unit normals (1,0) and (c,d) of a right turn: their cosine is above -1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(assert (= (+ (* 1.0 c c) (* 1.0 d d) (- 1.0)) 0.0))
(assert (> (* (- 1.0) d) 0.0))
(assert (>= (+ (* (- 1.0) c) (- 1.0)) 0.0))
(check-sat)
