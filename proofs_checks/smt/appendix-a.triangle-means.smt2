; appendix-a.triangle-means: r^2 (X + Y + Z) = X Y Z gives 4 r^2 (X + Y + Z) <= (X + Y)^2 Z
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const Y Real)
(declare-const Z Real)
(declare-const r Real)
(assert (> (* 1.0 X) 0.0))
(assert (> (* 1.0 Y) 0.0))
(assert (> (* 1.0 Z) 0.0))
(assert (> (* 1.0 r) 0.0))
(assert (= (+ (* (- 1.0) X Y Z) (* 1.0 X r r) (* 1.0 Y r r) (* 1.0 Z r r)) 0.0))
(assert (> (+ (* (- 2.0) X Y Z) (* 4.0 X r r) (* (- 1.0) X X Z) (* 4.0 Y r r) (* (- 1.0) Y Y Z) (* 4.0 Z r r)) 0.0))
(check-sat)
