; offset.thickness-upper: n.k + n_y s >= g where upper is extreme
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
(assert (>= (+ (* (- (/ 667.0 2000.0)) nx) (* (/ 29.0 125.0) ny)) 0.0))
(assert (> (+ (* (- 1.0) ny s) (* (- (/ 3.0 40.0)) nx) (* (- (/ 87.0 250.0)) ny) (/ 29.0 125.0)) 0.0))
(check-sat)
