; count.foot: c before the lower end M of a leg: its foot is on the leg
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const M Real)
(declare-const c Real)
(assert (> (* 1.0 c) 0.0))
(assert (> (+ (* 1.0 M) (* (- 1.0) c)) 0.0))
(assert (> (* 1.0 H) 0.0))
(assert (>= (+ (* (- 1.0) H H) (* 1.0 M c) (* (- 1.0) M M)) 0.0))
(check-sat)
