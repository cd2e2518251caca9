; columns-legs.depth-foot: a vertex of the leg is 0.0688 or more beside the corner
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const s Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 x) (- (/ 43.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 s) (- (/ 19.0 25.0))) 0.0))
(assert (> (+ (* (- 1.0) s x) (/ 261.0 5000.0)) 0.0))
(check-sat)
