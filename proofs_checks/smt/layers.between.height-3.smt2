; layers.between.height-3: two apexes p and q beside a T-vertex d above them: the height from corner 3
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const p Real)
(declare-const q Real)
(assert (>= (+ (* 1.0 p) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 q) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 d) (- 1.0)) 0.0))
(assert (> (+ (* (- 2.0) d d p q) (* (- 1.0) d d p p) (* (- 1.0) d d q q) (* (/ 18.0 25.0) p q) (* (/ 9.0 25.0) p p) (* (/ 9.0 25.0) q q)) 0.0))
(check-sat)
