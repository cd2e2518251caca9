; appendix-a.two-acute-not-one: both angles acute, y1 and y2 at distance 1 or more: |e'| > 1
; sat: false
(set-logic QF_NRA)
(declare-const L Real)
(declare-const j Real)
(declare-const k Real)
(assert (> (+ (* 1.0 k) (- 1.0)) 0.0))
(assert (> (+ (* 1.0 j) (- 1.0)) 0.0))
(assert (>= (+ (* 2.0 L j k) (* (- 1.0) j k k) (* (- 1.0) j j k) (* (- 2.0) j k) (* 1.0 j) (* 1.0 k)) 0.0))
(assert (>= (+ (* (- 1.0) L) (* (/ 1.0 4.0) j) (* (/ 1.0 4.0) k) 1.0) 0.0))
(check-sat)
