; columns-tube.first-right.height-3: (A, foot, v0), v0 between them: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const q Real)
(declare-const t Real)
(declare-const x Real)
(assert (>= (+ (* 1.0 q) (- (/ 3.0 40.0))) 0.0))
(assert (>= (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 q) (* (- 1.0) x)) 0.0))
(assert (>= (+ (* 1.0 t) (- (/ 29.0 125.0))) 0.0))
(assert (>= (+ (* (- 1.0) t) (/ 4701.0 10000.0)) 0.0))
(assert (> (+ (* (- 1.0) q q t t) (* (/ 49729.0 100000000.0) q q)) 0.0))
(check-sat)
