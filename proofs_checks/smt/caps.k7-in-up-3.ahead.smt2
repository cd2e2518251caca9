; caps.k7-in-up-3.ahead: k7, e' in, up, vertex 3 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(declare-const dy Real)
(declare-const dz Real)
(assert (>= (+ (* (- (/ 29.0 125.0)) dx) (* (/ 667.0 2000.0) dy)) 0.0))
(assert (>= (* (- (/ 3.0 20.0)) dy) 0.0))
(assert (> (* 1.0 dy) 0.0))
(assert (>= (* 1.0 dz) 0.0))
(assert (>= (+ (* (/ 967.0 2000.0) dx) (* (- (/ 58.0 125.0)) dz)) 0.0))
(assert (> (+ (* 1.0 dx dx) (* 1.0 dz dz)) 0.0))
(check-sat)
