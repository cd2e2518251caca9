"""Refute `section-1.linear-size`, `theorem-1.steiner-count` and `phase-4.vertex-count` for a whole family of triangles.

Given   the triangle (0,0), (4,H), (0,2 H), H >= 100, of mfs 4; the spacing is r <= 8/21. P4 has an edge on x = 1 from
        the level of K to that of 2 H - K, 4 K = H + sqrt(H^2 + 16), and a vertex on the level of H, whose chord puts
        the only vertex on that edge. Its position, in units of r from either end, is u, a whole number.
        Lemma 3: nodes x_1 = 1, x_i+1 <= 4 x_i (2 x_i in the text), the last one at u.
Claim   u >= H, so there are at least log4 H nodes, for n = 3 and one vertex on the rectangle.
Method  linear, but for the root.
Tight   no: there are log2 u nodes, up to rounding.
By hand that P4 has these vertices; the tests compare with the construction for several H, both spacings.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, equal, main, more, states

from exactmesh.proofs.polynomial import variables

H, K, s, r, u, x, y, q = variables("H K s r u x y q")
STATEMENTS = [
    states("linear-size.height", "(0,0) is 4 or more from the line of the opposite side: 64 H^2 >= 16 (16 + H^2)",
           (at_least(H, 100),), at_least(64 * H * H, 16 * (16 + H * H)), Hint(degrees=(2,))),
    states("linear-size.corner", "K <= H/2 + 1", (at_least(H, 100), at_least(s), at_least(H * H + 16, s * s),
                                                equal(4 * K, H + s)), at_least(H / 2 + 1, K), Hint(degrees=(2, 3))),
    states("linear-size.position", "levels are r/2 from H and K at most: u >= H",
           (at_least(H, 100), at_least(H / 2 + 1, K), more(r), at_least(mpq(8, 21), r), at_least(u * r + r, H - K)),
           at_least(u, H), Hint(degrees=(2, 3))),
    states("linear-size.octave", "one more node is at most 4 times as far", (at_least(q, x), at_least(4 * x, y)),
           at_least(4 * q, y)),
]
FAMILY = ("The corners of P3 on x = 1 are cot(w/2) from those of P, w the angle there, tan w = 4/H; T makes angles "
          "near 180 degrees with the spokes, so phase 2 cuts nothing off. By induction x_i <= 4^(i-1); the last one is "
          "u.")
NAMES = tuple(statement.id for statement in STATEMENTS)
GROUP = "linear-size"
THEOREMS = [
    Theorem("section-1.linear-size", "refuted", "the published construction has no bound for n = 3", NAMES, FAMILY),
    Theorem("theorem-1.steiner-count", "refuted", "36 a corner, or any other bound, is too few", NAMES, FAMILY),
    Theorem("phase-4.vertex-count", "refuted", "one vertex on a rectangle takes any number of new ones", NAMES, FAMILY),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
