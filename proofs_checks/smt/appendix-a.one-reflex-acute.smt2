; appendix-a.one-reflex-acute: one reflex end, w1 acute: |e'| >= sqrt(2)/2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 2.0 L k) (* (- 1.0) k k) (- 1.0)) 0.0))
(assert (> (+ (* 1.0 L k) (* (- 2.0) L L) (* (- (/ 1.0 8.0)) k k) 1.0) 0.0))
(check-sat)
