; layers.bound: l = log2 n; R + 1 is below 3 + log2 (17 n): what 3/5 g/(R + 1) allows
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const l Real)
(declare-const r Real)
(assert (>= (+ (* 1.0 l) (- 2.0)) 0.0))
(assert (>= (+ (* 1.0 l) (* (- 1.0) r) (/ 709.0 100.0)) 0.0))
(assert (> (+ (* (- (/ 1914.0 625.0)) l) (* (/ 1000001.0 1000000.0) r) (- (/ 1914.0 625.0))) 0.0))
(check-sat)
