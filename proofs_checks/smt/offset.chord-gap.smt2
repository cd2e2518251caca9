; offset.chord-gap: |p - c| >= 1 - rho, its vertical part at most 2 g: c is 0.15 + a or more beside p
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const r Real)
(declare-const s Real)
(assert (>= (* 1.0 r) 0.0))
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* 1.0 r r) (- (/ 28079401.0 100000000.0))) 0.0))
(assert (>= (+ (* (- 1.0) r r) (* 1.0 s s) (/ 3364.0 15625.0)) 0.0))
(assert (> (+ (* (- 1.0) s) (/ 9.0 40.0)) 0.0))
(check-sat)
