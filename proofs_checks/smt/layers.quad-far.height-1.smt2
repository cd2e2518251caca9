; layers.quad-far.height-1: the further neighbour and the two of the next row: the height from corner 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(declare-const k Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 2.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (>= (+ (* (- 1.0) c) (* 1.0 k)) 0.0))
(assert (>= (* 1.0 b) 0.0))
(assert (> (+ (* (- 2.0) b c k k) (* (- 2.0) b d k k) (* (- 1.0) b b k k) (* (- 2.0) c d k k) (* (- 1.0) c c k k) (* (- 1.0) d d k k) (* (/ 18.0 25.0) b c) (* (/ 18.0 25.0) b d) (* (/ 9.0 25.0) b b) (* (/ 18.0 25.0) c d) (* (/ 9.0 25.0) c c) (* (/ 9.0 25.0) d d)) 0.0))
(check-sat)
