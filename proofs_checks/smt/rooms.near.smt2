; rooms.near: L < o: the leg of f passes over c within 0.057, but c is 0.0599 from it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const h Real)
(declare-const o Real)
(assert (> (* 1.0 L) 0.0))
(assert (> (+ (* (- 1.0) L) (* 1.0 o)) 0.0))
(assert (= (+ (* 1.0 h o) (* (- (/ 57.0 1000.0)) L)) 0.0))
(assert (>= (+ (* 1.0 h) (- (/ 599.0 10000.0))) 0.0))
(check-sat)
