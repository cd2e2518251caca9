; p2.case-2-lower: Lemma 1, case-2: the vertex is to the left of the lower side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const h Real)
(declare-const l Real)
(declare-const m Real)
(assert (> (* 1.0 l) 0.0))
(assert (> (* 1.0 h) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (>= (* 1.0 m) 0.0))
(assert (>= (* (- (/ 1.0 2.0)) h l) 0.0))
(check-sat)
