; tilings.on-edge: e_i+1 is at most at 1 and at least at 1/3: positions are below it, vertices inside
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const x Real)
(declare-const y Real)
(assert (> (* 1.0 x) 0.0))
(assert (>= (+ (* 1.0 X) (* (- 1.0) x)) 0.0))
(assert (= (+ (* 3.0 X y) (* (- 3.0) X) (* 2.0 x)) 0.0))
(assert (> (+ (* (- 1.0) y) (/ 1.0 3.0)) 0.0))
(check-sat)
