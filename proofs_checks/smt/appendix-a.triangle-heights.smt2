; appendix-a.triangle-heights: two heights of 1 or more: 4 r (e + Z) >= e + 2 Z, where e = X + Y
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const Y Real)
(declare-const Z Real)
(declare-const r Real)
(assert (>= (+ (* 2.0 X r) (* 2.0 Y r) (* 2.0 Z r) (* (- 1.0) Y) (* (- 1.0) Z)) 0.0))
(assert (>= (+ (* 2.0 X r) (* 2.0 Y r) (* 2.0 Z r) (* (- 1.0) X) (* (- 1.0) Z)) 0.0))
(assert (> (+ (* (- 4.0) X r) (* (- 4.0) Y r) (* (- 4.0) Z r) (* 1.0 X) (* 1.0 Y) (* 2.0 Z)) 0.0))
(check-sat)
