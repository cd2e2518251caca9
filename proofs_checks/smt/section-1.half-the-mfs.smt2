; section-1.half-the-mfs: an error e below the mfs keeps (0,0) off the edge from (1,0) to (1,1)
; sat: false
(set-logic QF_NRA)
(declare-const e Real)
(assert (>= (* 1.0 e) 0.0))
(assert (> (+ (* (- 1.0) e) 1.0) 0.0))
(assert (>= (+ (* (- 4.0) e e) (* 4.0 e) (- 1.0)) 0.0))
(check-sat)
