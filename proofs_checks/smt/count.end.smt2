; count.end: a right leg from n to h, left corners c and k beside: it does not lean far out both ways
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const h Real)
(declare-const k Real)
(declare-const n Real)
(declare-const r Real)
(assert (> (* 1.0 r) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 1.0) k)) 0.0))
(assert (>= (+ (* (- 1.0) c) (* 1.0 n)) 0.0))
(assert (> (+ (* 1.0 k) (* (- 1.0) n) (* (- 1.0) r)) 0.0))
(assert (> (+ (* 1.0 c) (* (- 1.0) h) (* (- 1.0) r)) 0.0))
(check-sat)
