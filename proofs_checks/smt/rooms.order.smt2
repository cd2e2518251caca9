; rooms.order: columns from x and y > x: where both are ends to choose from, the nearest are in order
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(declare-const q Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (+ (* (- 1.0) x) (* 1.0 y)) 0.0))
(assert (> (+ (* 1.0 p) (* (- 1.0) q)) 0.0))
(assert (>= (+ (* 2.0 p x) (* (- 1.0) p p) (* (- 2.0) q x) (* 1.0 q q)) 0.0))
(assert (>= (+ (* (- 2.0) p y) (* 1.0 p p) (* 2.0 q y) (* (- 1.0) q q)) 0.0))
(check-sat)
