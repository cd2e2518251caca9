; p6-gap.distance: the T-vertex is nearer than (18/17)/(L - 1/2) to the spoke
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const L Real)
(declare-const T Real)
(assert (>= (+ (* 1.0 L) (- 6.0)) 0.0))
(assert (>= (+ (* 1.0 T) (- 2.0)) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 9.0 4.0)) 0.0))
(assert (> (* 1.0 H) 0.0))
(assert (>= (+ (* (- 1.0) H) (/ 9.0 17.0)) 0.0))
(assert (>= (+ (* (/ 1.0 4.0) H H L L T T) (* (- (/ 1.0 4.0)) H H L T T) (* (- (/ 1.0 8.0)) H H L L T) (* (/ 1.0 8.0) H H L T) (* (/ 1.0 64.0) H H L L) (* (/ 1.0 16.0) H H T T) (* (- (/ 1.0 64.0)) H H L) (* (- (/ 1.0 32.0)) H H T) (* (- (/ 20447.0 73984.0)) H H) (* (- (/ 81.0 289.0)) L L) (* (/ 81.0 289.0) L) (- (/ 81.0 1156.0))) 0.0))
(check-sat)
