; tall.bottom-b: (L, R, s): height b
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 l) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 x) (/ 3.0 20.0)) 0.0))
(assert (>= (+ (* 1.0 l) (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(assert (> (+ (* (- (/ 1.0 64.0)) l l) (* (/ 9.0 15625.0) x x) (/ 9.0 1000000.0)) 0.0))
(check-sat)
