; tiles.far: a foot d below its vertex, the far corner, the vertex: turns left
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const M Real)
(declare-const d Real)
(assert (> (* 1.0 M) 0.0))
(assert (> (* 1.0 d) 0.0))
(assert (>= (* (- 1.0) M d) 0.0))
(check-sat)
