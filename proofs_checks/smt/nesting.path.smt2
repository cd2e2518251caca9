; nesting.path: n0.k1 < h and n0.d1 <= 0 for a cap: n0 on e1' stays below h
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const h Real)
(declare-const m Real)
(declare-const s Real)
(assert (> (+ (* 1.0 h) (* (- 1.0) m)) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (* (- 1.0) c) 0.0))
(assert (>= (+ (* 1.0 c s) (* (- 1.0) h) (* 1.0 m)) 0.0))
(check-sat)
