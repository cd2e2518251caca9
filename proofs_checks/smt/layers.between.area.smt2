; layers.between.area: two apexes p and q beside a T-vertex d above them: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const p Real)
(declare-const q Real)
(assert (>= (+ (* 1.0 p) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 q) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (>= (+ (* (- 1.0) d p) (* (- 1.0) d q)) 0.0))
(check-sat)
