; section-5.end: what is below the line and above e is v - w wide or less, at most w
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const e Real)
(declare-const g Real)
(declare-const v Real)
(declare-const w Real)
(assert (> (* 1.0 e) 0.0))
(assert (> (* 1.0 w) 0.0))
(assert (>= (+ (* (- 1.0) e) (* 1.0 g)) 0.0))
(assert (> (+ (* 2.0 e) (* (- 1.0) g)) 0.0))
(assert (= (+ (* 1.0 e v) (* (- 1.0) g w)) 0.0))
(assert (> (+ (* 1.0 v) (* (- 2.0) w)) 0.0))
(check-sat)
