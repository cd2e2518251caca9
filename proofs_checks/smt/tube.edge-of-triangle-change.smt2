; tube.edge-of-triangle-change: so do 90 degrees in triangles: a change of 663/2000 at most does not reach it
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const ex Real)
(declare-const ey Real)
(assert (>= (+ (* (- 1.0) ex ex) (* (- 1.0) ey ey) (/ 439569.0 4000000.0)) 0.0))
(assert (> (+ (* 8.0 ex) (* (- 15.0) ey) (- (/ 11271.0 2000.0))) 0.0))
(check-sat)
