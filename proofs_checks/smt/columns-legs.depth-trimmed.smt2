; columns-legs.depth-trimmed: a chord vertex is 0.057 or more above a leg of slope 0.76 or less
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 y) (- (/ 57.0 1000.0))) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 19.0 25.0)) 0.0))
(assert (> (+ (* (/ 81.0 40000.0) s s) (* (- 1.0) y y) (/ 81.0 40000.0)) 0.0))
(check-sat)
