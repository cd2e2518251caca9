; rooms.beside: v, x beside the end of a leg of slope s, is 0.0599 from it: that end and what is below v
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(assert (> (* 1.0 s) 0.0))
(assert (> (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 s s x x) (* (- (/ 358801.0 100000000.0)) s s) (- (/ 358801.0 100000000.0))) 0.0))
(assert (> (+ (* (- 1.0) s s x x) (* (- 1.0) x x) (/ 9.0 1600.0)) 0.0))
(check-sat)
