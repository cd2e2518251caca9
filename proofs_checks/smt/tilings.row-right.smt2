; tilings.row-right: (a, b, C), b below a or after it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(declare-const y Real)
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* (- 1.0) d) (* (- 1.0) y) 1.0) 0.0))
(assert (>= (+ (* 1.0 a) (* (- 1.0) b)) 0.0))
(assert (> (+ (* (- 1.0) a) (* 1.0 c)) 0.0))
(assert (>= (+ (* 1.0 a d) (* 1.0 a y) (* (- 1.0) b y) (* (- 1.0) c d) (* (- 1.0) a) (* 1.0 b)) 0.0))
(check-sat)
