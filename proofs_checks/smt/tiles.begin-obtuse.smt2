; tiles.begin-obtuse: s x = h - c k, h <= s m + c k: x <= m
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const h Real)
(declare-const k Real)
(declare-const m Real)
(declare-const s Real)
(declare-const x Real)
(assert (> (* 1.0 s) 0.0))
(assert (= (+ (* 1.0 c k) (* 1.0 s x) (* (- 1.0) h)) 0.0))
(assert (>= (+ (* 1.0 c k) (* 1.0 m s) (* (- 1.0) h)) 0.0))
(assert (> (+ (* (- 1.0) m) (* 1.0 x)) 0.0))
(check-sat)
