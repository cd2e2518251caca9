; tiles.cap-1: an edge of K1 after at most half a level, and p, all m times their size: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const m Real)
(declare-const s Real)
(assert (> (* 1.0 m) 0.0))
(assert (>= (+ (* (/ 29.0 125.0) m) (* 2.0 s)) 0.0))
(assert (>= (+ (* (/ 29.0 125.0) m) (* (- 2.0) s)) 0.0))
(assert (>= (+ (* (- (/ 667.0 2000.0)) m s) (* (- (/ 66729.0 500000.0)) m m)) 0.0))
(check-sat)
