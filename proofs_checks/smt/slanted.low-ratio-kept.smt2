; slanted.low-ratio-kept: then that leader keeps 1/5 from the line of the one beyond E, so it is none
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const w Real)
(assert (>= (+ (* 1.0 w) (- (/ 1.0 2.0))) 0.0))
(assert (>= (+ (* 1.0 c) (- (/ 31.0 40.0))) 0.0))
(assert (>= (+ (* (- 1.0) c) (/ 4.0 5.0)) 0.0))
(assert (>= (+ (* 1.0 c w) (* (- (/ 4.0 5.0)) w) (/ 527.0 5000.0)) 0.0))
(assert (> (+ (* (- 25.0) c c w w) (* (- (/ 67.0 2.0)) c c w) (* 2.0 c c) (* 16.0 w w) (* 12.0 w) 2.0) 0.0))
(check-sat)
