; p2.prolonged-beyond: b s + c/4 = 1/4, an arc below 90 degrees: b > 0
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const c Real)
(declare-const s Real)
(assert (= (+ (* 1.0 c c) (* 1.0 s s) (- 1.0)) 0.0))
(assert (> (* 1.0 s) 0.0))
(assert (> (* 1.0 c) 0.0))
(assert (= (+ (* 4.0 b s) (* 1.0 c) (- 1.0)) 0.0))
(assert (>= (* (- 1.0) b) 0.0))
(check-sat)
