; tube.height: so that a' and b', D below, are r/2 above B
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const D Real)
(declare-const m Real)
(declare-const n Real)
(declare-const r Real)
(assert (>= (+ (* (- 1.0) m) (* (/ 1.0 2.0) r) (/ 13.0 5637144576.0)) 0.0))
(assert (>= (+ (* (- 1.0) D) (* (- (/ 67108863.0 67108864.0)) n) (/ 67108863.0 268435456.0)) 0.0))
(assert (>= (+ (* 1.0 n) (* (- 1.0) r)) 0.0))
(assert (>= (+ (* (- 1.0) n) (/ 2.0 21.0)) 0.0))
(assert (> (+ (* 1.0 D) (* 1.0 m) (* (/ 1.0 2.0) r) (- (/ 1.0 4.0))) 0.0))
(check-sat)
