; lemma-2.triangle-inequality: |b| <= r and |c| <= s imply |b - c| <= r + s
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const bx Real)
(declare-const cx Real)
(declare-const cy Real)
(declare-const r Real)
(declare-const s Real)
(assert (> (* 1.0 r) 0.0))
(assert (> (* 1.0 s) 0.0))
(assert (>= (+ (* (- 1.0) bx bx) (* 1.0 r r)) 0.0))
(assert (>= (+ (* (- 1.0) cx cx) (* (- 1.0) cy cy) (* 1.0 s s)) 0.0))
(assert (> (+ (* (- 2.0) bx cx) (* 1.0 bx bx) (* 1.0 cx cx) (* 1.0 cy cy) (* (- 2.0) r s) (* (- 1.0) r r) (* (- 1.0) s s)) 0.0))
(check-sat)
