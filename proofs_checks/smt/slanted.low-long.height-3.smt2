; slanted.low-long.height-3: the height from E over A-F, which goes e + D across
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const T Real)
(declare-const c Real)
(assert (>= (+ (* 1.0 T) (- (/ 987.0 10000.0))) 0.0))
(assert (>= (+ (* (- 1.0) T) (/ 1.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 c) (- (/ 31.0 40.0))) 0.0))
(assert (>= (+ (* (- 1.0) c) (/ 4.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 D) (* (- (/ 129.0 50.0)) T)) 0.0))
(assert (> (+ (* 4.0 D D T T) (* (- 1.0) D D c c) (* 1.0 T T c c) (* 1.0 T T)) 0.0))
(check-sat)
