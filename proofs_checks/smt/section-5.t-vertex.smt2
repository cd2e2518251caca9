; section-5.t-vertex: a vertex (t, 0) is as far from the line x = 2 y as the least height, squared
; sat: false
(set-logic QF_NRA)
(declare-const t Real)
(assert (> (* 1.0 t) 0.0))
(assert (>= (+ (* (- 1.0) t) 8.0) 0.0))
(assert (> (+ (* (- 1.0) t t) 16.0) 0.0))
(check-sat)
