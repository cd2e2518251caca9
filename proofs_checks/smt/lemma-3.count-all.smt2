; lemma-3.count-all: k nodes, k - 1 tops, t teeth: t <= c - 1, k <= L <= c - 1
; unsat: true for all reals
(set-logic QF_NRA)
(declare-const c Real)
(declare-const k Real)
(declare-const t Real)
(assert (>= (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (>= (* 1.0 t) 0.0))
(assert (>= (+ (* 1.0 c) (* (- 1.0) t) (- 1.0)) 0.0))
(assert (>= (+ (* 1.0 c) (* (- 1.0) k) (- 1.0)) 0.0))
(assert (> (+ (* (- 3.0) c) (* 2.0 k) (* 1.0 t) (- 1.0)) 0.0))
(check-sat)
