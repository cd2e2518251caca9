; wedges.w2-upper.area: v_i, v_i', v_i+1: counter-clockwise
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const d Real)
(declare-const s Real)
(declare-const x Real)
(assert (>= (* 1.0 s) 0.0))
(assert (>= (+ (* (- 2.0) s) 1.0) 0.0))
(assert (>= (+ (* 1.0 x) (- (/ 3.0 20.0))) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (+ (* 1.0 d d) (* (- (/ 358801.0 100000000.0)) s s) (- (/ 358801.0 100000000.0))) 0.0))
(assert (>= (* (- 1.0) d x) 0.0))
(check-sat)
