; rooms.fan: vertices (x, y), (x + t a, y + t b) of an e' whose line is above p: p, the later, the earlier
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const t Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 t) 0.0))
(assert (> (+ (* 1.0 a y) (* (- 1.0) b x)) 0.0))
(assert (>= (+ (* (- 1.0) a t y) (* 1.0 b t x)) 0.0))
(check-sat)
