; columns-legs.above.height-1: (P0, F0, P1), P0 = (0, 0), F0 = (x, -y), P1 = (p, 0): the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const p Real)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 p) (- (/ 43.0 625.0))) 0.0))
(assert (>= (+ (* 1.0 x) (/ 3.0 40.0)) 0.0))
(assert (>= (+ (* (- 1.0) x) (/ 3.0 40.0)) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 261.0 5000.0))) 0.0))
(assert (> (+ (* (- 1.0) p p y y) (* (- (/ 49729.0 50000000.0)) p x) (* (/ 49729.0 100000000.0) p p) (* (/ 49729.0 100000000.0) x x) (* (/ 49729.0 100000000.0) y y)) 0.0))
(check-sat)
