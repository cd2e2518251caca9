; offset.reach-side: n.k + n_y s <= 0.4701 for side
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const nx Real)
(declare-const ny Real)
(declare-const s Real)
(assert (= (+ (* 1.0 nx nx) (* 1.0 ny ny) (- 1.0)) 0.0))
(assert (>= (* 1.0 nx) 0.0))
(assert (>= (* 1.0 ny) 0.0))
(assert (>= (+ (* 2.0 s) (/ 29.0 125.0)) 0.0))
(assert (>= (+ (* (- 2.0) s) (/ 29.0 125.0)) 0.0))
(assert (> (+ (* 1.0 ny s) (* (/ 817.0 2000.0) nx) (* (/ 29.0 250.0) ny) (- (/ 4701.0 10000.0))) 0.0))
(check-sat)
