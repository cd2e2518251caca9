; columns-legs.depth-corner: that high above the leg
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 s) (- (/ 19.0 25.0))) 0.0))
(assert (> (+ (* (- 1.0) s x) (/ 113.0 2000.0)) 0.0))
(check-sat)
