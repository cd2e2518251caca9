; tilings.position-most: on an edge that rises m levels, the point on level j is j w from its end, m w the edge's length
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const X Real)
(declare-const g Real)
(declare-const j Real)
(declare-const m Real)
(declare-const w Real)
(declare-const x Real)
(assert (> (* 1.0 m) 0.0))
(assert (= (+ (* (- 1.0) g g m m) (* 1.0 m m w w) (* (- 1.0) X X)) 0.0))
(assert (= (+ (* (- 1.0) X j) (* 1.0 m x)) 0.0))
(assert (> (+ (* 1.0 g g j j m m) (* (- 1.0) j j m m w w) (* 1.0 m m x x)) 0.0))
(check-sat)
