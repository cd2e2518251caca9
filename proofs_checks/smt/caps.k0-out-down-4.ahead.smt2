; caps.k0-out-down-4.ahead: k0, e' out, down, vertex 4 steps away; the foot is on the ray
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const dx Real)
(declare-const dy Real)
(declare-const dz Real)
(assert (>= (* (- (/ 29.0 125.0)) dx) 0.0))
(assert (>= (+ (* (/ 29.0 125.0) dx) (* (- (/ 667.0 2000.0)) dy)) 0.0))
(assert (> (* (- 1.0) dy) 0.0))
(assert (>= (* (- 1.0) dz) 0.0))
(assert (>= (+ (* (- (/ 817.0 1000.0)) dx) (* (/ 29.0 125.0) dz)) 0.0))
(assert (> (+ (* 1.0 dx dx) (* 1.0 dz dz)) 0.0))
(assert (> (+ (* (- (/ 23693.0 62500.0)) dx dz) (* (- (/ 7831.0 250000.0)) dx dx) (* (- (/ 644989.0 1000000.0)) dz dz)) 0.0))
(check-sat)
