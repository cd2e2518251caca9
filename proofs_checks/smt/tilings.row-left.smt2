; tilings.row-left: (A, b_0, a_0), a_0 above the next vertex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const d Real)
(declare-const y Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d) (* (- 1.0) y) 1.0) 0.0))
(assert (> (* 1.0 a) 0.0))
(assert (> (+ (* (- 1.0) a) (* 1.0 b)) 0.0))
(assert (>= (+ (* (- 1.0) a d) (* (- 1.0) a y) (* 1.0 b y) (* 1.0 a) (* (- 1.0) b)) 0.0))
(check-sat)
