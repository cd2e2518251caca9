; lemma-3.stretch: stretching by w, h >= m makes lengths m times as long or longer
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const h Real)
(declare-const m Real)
(declare-const w Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* (- 1.0) m) (* 1.0 w)) 0.0))
(assert (>= (+ (* 1.0 h) (* (- 1.0) m)) 0.0))
(assert (> (+ (* (- 1.0) h h y y) (* 1.0 m m x x) (* 1.0 m m y y) (* (- 1.0) w w x x)) 0.0))
(check-sat)
