; slanted.low-tooth-apex: a tooth, d deep: the height from its apex
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const s Real)
(assert (>= (+ (* 1.0 s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) s) (/ 1.0 2.0)) 0.0))
(assert (>= (+ (* (- (/ 29.0 1250.0)) s s) (* 1.0 d) (- (/ 29.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 29.0 625.0))) 0.0))
(assert (> (+ (* (/ 29.0 1250.0) s s) (* (- 1.0) d) (/ 29.0 625.0)) 0.0))
(check-sat)
