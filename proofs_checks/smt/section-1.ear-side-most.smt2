; section-1.ear-side-most: the square of a side is 2 (1 - c), at most
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const s Real)
(assert (= (+ (* 1.0 c c) (* 1.0 s s) (- 1.0)) 0.0))
(assert (>= (* 1.0 c) 0.0))
(assert (> (+ (* (- 1.0) c) 1.0) 0.0))
(assert (> (+ (* 1.0 c c) (* 1.0 s s) (- 1.0)) 0.0))
(check-sat)
