; appendix-a.unit-edge: at an edge of length 1 no angle is acute
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) L) 1.0) 0.0))
(assert (>= (+ (* 2.0 L k) (* (- 1.0) k k) (- 1.0)) 0.0))
(check-sat)
