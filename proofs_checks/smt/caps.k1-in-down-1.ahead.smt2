; caps.k1-in-down-1.ahead: k1, e' in, down, vertex 1 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(declare-const dy Real)
(declare-const dz Real)
(assert (>= (+ (* (- (/ 29.0 125.0)) dx) (* (- (/ 667.0 2000.0)) dy)) 0.0))
(assert (>= (* (/ 29.0 125.0) dx) 0.0))
(assert (> (* (- 1.0) dy) 0.0))
(assert (>= (* (- 1.0) dz) 0.0))
(assert (>= (* (/ 29.0 125.0) dz) 0.0))
(assert (> (+ (* 1.0 dx dx) (* 1.0 dz dz)) 0.0))
(assert (> (+ (* (- (/ 7831.0 250000.0)) dx dx) (* (/ 9.0 400.0) dz dz)) 0.0))
(check-sat)
