; tiles.leg-once: a left leg, from a above to b below, is not reached from both sides, at v and at w
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const a Real)
(declare-const b Real)
(declare-const v Real)
(declare-const w Real)
(assert (> (* 1.0 X) 0.0))
(assert (>= (+ (* (- 1.0) a) (* 1.0 v)) 0.0))
(assert (> (+ (* (- 1.0) X) (* 1.0 b) (* (- 1.0) v)) 0.0))
(assert (>= (+ (* (- 1.0) b) (* 1.0 w)) 0.0))
(assert (> (+ (* (- 1.0) X) (* 1.0 a) (* (- 1.0) w)) 0.0))
(check-sat)
