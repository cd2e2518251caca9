; columns-legs.below-high: and 1.14 w at most above it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const s Real)
(declare-const w Real)
(assert (>= (+ (* (- (/ 9.0 200.0)) s) (* 1.0 w)) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* 1.0 q) (/ 31.0 5000.0)) 0.0))
(assert (>= (* (- 1.0) q) 0.0))
(assert (>= (* 1.0 w) 0.0))
(assert (> (+ (* (- 1.0) q s) (* (- (/ 7.0 50.0)) w)) 0.0))
(check-sat)
