; appendix-a.q1-foot: if the foot of p2 is beyond u, that of q1 is on e, so that q1 is at depth 1 or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const L Real)
(declare-const c Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) c k k k k) (* 1.0 L k k) (* (- 2.0) c k k) (* (- 1.0) L) (* (- 1.0) c)) 0.0))
(assert (>= (+ (* 1.0 c k k) (* (- 1.0) L) (* (- 1.0) c)) 0.0))
(check-sat)
