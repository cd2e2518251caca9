; rooms.depth: o <= r: the foot at f is within 0.171 of the chord
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const o Real)
(declare-const r Real)
(assert (> (+ (* 1.0 r) (- (/ 3.0 40.0))) 0.0))
(assert (>= (* 1.0 o) 0.0))
(assert (>= (+ (* (- 1.0) o) (* 1.0 r)) 0.0))
(assert (>= (+ (* (- 1.0) L) (* 1.0 o) (* 1.0 r) (/ 3.0 40.0)) 0.0))
(assert (>= (+ (* 1.0 L) (* (- 3.0) r)) 0.0))
(check-sat)
