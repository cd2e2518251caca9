; tiles.side-once: v is not dropped on both legs, which are at b and c >= b on the other level
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const b Real)
(declare-const c Real)
(declare-const v Real)
(assert (> (* 1.0 X) 0.0))
(assert (> (+ (* (- 1.0) X) (* 1.0 b) (* (- 1.0) v)) 0.0))
(assert (> (+ (* (- 1.0) X) (* (- 1.0) c) (* 1.0 v)) 0.0))
(assert (>= (+ (* (- 1.0) b) (* 1.0 c)) 0.0))
(check-sat)
