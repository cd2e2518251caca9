; tube.fan: the sine of a fan's edge with its chord is 1/4 or more, after snapping
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const C Real)
(declare-const S Real)
(assert (>= (+ (* (- 1.0) C C) (* (- 1.0) S S) 1.0) 0.0))
(assert (>= (+ (* 1.0 C C) (* 1.0 S S) (- (/ 999.0 1000.0))) 0.0))
(assert (>= (+ (* 1.0 S) (- (/ 191.0 500.0))) 0.0))
(assert (>= (+ (* (- 1.0) S) (/ 71.0 100.0)) 0.0))
(assert (>= (+ (* 1.0 C) (- (/ 7.0 10.0))) 0.0))
(assert (>= (+ (* (- 1.0) C) (/ 93.0 100.0)) 0.0))
(assert (> (+ (* (- (/ 1.0 2.0)) C S) (* (/ 2.0 21.0) C) (* (/ 819221.0 5505024.0) S) (/ 107462951353.0 3788161155072.0)) 0.0))
(check-sat)
