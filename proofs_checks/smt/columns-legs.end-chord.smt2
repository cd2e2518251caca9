; columns-legs.end-chord: the height over the chord
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 p) (- (/ 43.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 9.0 200.0))) 0.0))
(assert (>= (+ (* (- 1.0) p) (* 1.0 x) (/ 3.0 40.0)) 0.0))
(assert (>= (+ (* 1.0 p) (* (- 1.0) x) (/ 3.0 40.0)) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (> (+ (* (- 1.0) y) (/ 223.0 10000.0)) 0.0))
(check-sat)
