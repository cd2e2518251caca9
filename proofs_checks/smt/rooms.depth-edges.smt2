; rooms.depth-edges: L < o: the same, as the edges of c and f do not cross
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const o Real)
(declare-const r Real)
(assert (> (+ (* 1.0 r) (- (/ 3.0 40.0))) 0.0))
(assert (> (* 1.0 L) 0.0))
(assert (> (+ (* (- 1.0) L) (* 1.0 o)) 0.0))
(assert (>= (+ (* (/ 57.0 1000.0) L) (* (- (/ 29.0 125.0)) o) (* (/ 29.0 125.0) r)) 0.0))
(assert (>= (+ (* 1.0 L) (* (- 3.0) r)) 0.0))
(check-sat)
