; rooms.tilt-slanted: e' = (m c, d) is not level, e = (c, k): forward by more than 0.075 c
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const d Real)
(declare-const k Real)
(declare-const m Real)
(assert (= (+ (* 1.0 c c) (* 1.0 k k) (- 1.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (>= (* 1.0 k) 0.0))
(assert (>= (+ (* 1.0 m) (- (/ 3.0 20.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) c c m) (* (- 1.0) d k) (* (/ 3.0 40.0) c)) 0.0))
(check-sat)
