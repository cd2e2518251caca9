; columns-legs.step.height-2: corner, foot, k: the height from corner 2
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const x Real)
(declare-const y Real)
(assert (>= (+ (* 1.0 x) (- (/ 3.0 40.0))) 0.0))
(assert (>= (+ (* 1.0 y) (- (/ 57.0 1000.0))) 0.0))
(assert (> (+ (* (- 1.0) x x y y) (* (/ 49729.0 100000000.0) x x)) 0.0))
(check-sat)
