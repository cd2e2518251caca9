; tall.bottom-a: (L, R, s): height a
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 l) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 x) (/ 3.0 20.0)) 0.0))
(assert (>= (+ (* 1.0 l) (* (- 1.0) x) (/ 3.0 20.0)) 0.0))
(assert (> (+ (* (- (/ 18.0 15625.0)) l x) (* (- (/ 15049.0 1000000.0)) l l) (* (/ 9.0 15625.0) x x) (/ 9.0 1000000.0)) 0.0))
(check-sat)
