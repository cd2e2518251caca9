; tube.low-outside: (a', L, s) onto L a'
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const k Real)
(declare-const p Real)
(declare-const v Real)
(assert (>= (+ (* 1.0 p) (- (/ 5.0 4.0))) 0.0))
(assert (>= (+ (* 1.0 d) (- (/ 9.0 10.0))) 0.0))
(assert (>= (+ (* 1.0 k) (- (/ 49999999.0 100000000.0))) 0.0))
(assert (>= (+ (* (- 1.0) v) (/ 1.0 4.0)) 0.0))
(assert (>= (+ (* 1.0 v) (- (/ 4194303.0 16777216.0))) 0.0))
(assert (> (+ (* 2.0 d k p v) (* (- 2.0) d k k p) (* (- 1.0) d d k k) (* 2.0 k p p v) (* (- 1.0) k k p p) (* (- 1.0) p p v v) (* (/ 999998000001.0 16000000000000.0) k k) (* (/ 999998000001.0 16000000000000.0) p p)) 0.0))
(check-sat)
