; tall.bottom-c: (L, R, s): height c
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 l) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 x) (/ 3.0 20.0)) 0.0))
(assert (>= (+ (* 1.0 l) (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(assert (> (* (- (/ 15049.0 1000000.0)) l l) 0.0))
(check-sat)
