; paper-tube-tiles.before: t is still before R, and u after L
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const m Real)
(declare-const p Real)
(declare-const p0 Real)
(assert (>= (+ (* 1.0 l) (* (- 1.0) p0) (- (/ 1.0 4.0))) 0.0))
(assert (>= (+ (* 1.0 m) (* (- 1.0) p) (* 1.0 p0)) 0.0))
(assert (>= (+ (* (- 1.0) m) (/ 1.0 20.0)) 0.0))
(assert (>= (+ (* (- 1.0) l) (* 1.0 p)) 0.0))
(check-sat)
