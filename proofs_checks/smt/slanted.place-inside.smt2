; slanted.place-inside: from 90 degrees on D is at least as far along as k = (q, n), extreme for e; p = n1.k1 is at least n1.k
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const n Real)
(declare-const p Real)
(declare-const q Real)
(declare-const s Real)
(declare-const x Real)
(assert (> (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) c n) (* (- 1.0) q s) (* 1.0 p)) 0.0))
(assert (= (+ (* 1.0 c n) (* 1.0 s x) (* (- 1.0) p)) 0.0))
(assert (> (+ (* 1.0 q) (* (- 1.0) x)) 0.0))
(check-sat)
