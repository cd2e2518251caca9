; tilings.beside-low: (E, u, F), u anywhere on the side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const x Real)
(assert (> (+ (* 1.0 X) (* (- 1.0) x)) 0.0))
(assert (>= (+ (* (- (/ 1.0 3.0)) X) (* (/ 1.0 3.0) x)) 0.0))
(check-sat)
