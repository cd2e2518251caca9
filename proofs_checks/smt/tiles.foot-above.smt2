; tiles.foot-above: and above the far corner
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const H Real)
(declare-const M Real)
(declare-const d Real)
(declare-const x Real)
(assert (> (* 1.0 x) 0.0))
(assert (> (+ (* 1.0 M) (* (- 1.0) x)) 0.0))
(assert (> (* 1.0 H) 0.0))
(assert (= (+ (* (- 1.0) H x) (* 1.0 M d)) 0.0))
(assert (>= (+ (* (- 1.0) H) (* 1.0 d)) 0.0))
(check-sat)
