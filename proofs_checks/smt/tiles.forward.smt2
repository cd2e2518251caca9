; tiles.forward: e' = (m c, d) is not level and e = (c, k) not upright, or both as e: forward
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const k Real)
(declare-const m Real)
(assert (> (* 1.0 m) 0.0))
(assert (> (* 1.0 c c) 0.0))
(assert (>= (* 1.0 d k) 0.0))
(assert (>= (+ (* (- 1.0) c c m) (* (- 1.0) d k)) 0.0))
(check-sat)
