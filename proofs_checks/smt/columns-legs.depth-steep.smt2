; columns-legs.depth-steep: a chord vertex is 0.075 or more from the corner, the slope 0.76 or more
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 s) (- (/ 19.0 25.0))) 0.0))
(assert (> (+ (* (- 1.0) s s x x) (* (/ 81.0 40000.0) s s) (/ 81.0 40000.0)) 0.0))
(check-sat)
