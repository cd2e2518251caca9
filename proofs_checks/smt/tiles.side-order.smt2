; tiles.side-order: what is dropped to the left, v, is before what is dropped to the right, w
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const b Real)
(declare-const c Real)
(declare-const v Real)
(declare-const w Real)
(assert (> (* 1.0 X) 0.0))
(assert (> (+ (* (- 1.0) X) (* 1.0 b) (* (- 1.0) v)) 0.0))
(assert (> (+ (* (- 1.0) X) (* (- 1.0) c) (* 1.0 w)) 0.0))
(assert (>= (+ (* (- 1.0) b) (* 1.0 c)) 0.0))
(assert (>= (+ (* 1.0 v) (* (- 1.0) w)) 0.0))
(check-sat)
