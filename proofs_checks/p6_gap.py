"""Refute `section-2.p6-degradation`, `section-2.interior-feature-size` and `theorem-1.degradation` for a whole family.

Given   the hexagon (0,1), (2,1), (2,0), (L,0), (L,2), (0,2), L >= 6, of mfs 1. P4 has the corners (1/4, y), (T, y),
        (L - 1/4, y'), (1/4, y') of a trapezoid of P5: y and y' are the levels of 5/4 and 7/4, T = 2 or T = 9/4 is the
        first point of the corner at (2,1), by the rule for 90 degrees. With the spacing 2/21, y' - y = H = 10/21, with
        3/34 it is 9/17. None of this depends on L, and (T, y) is a T-vertex of the trapezoid. Lemma 1 puts
        s = (L/2, y + H/2).
Claim   (T, y) is nearer than (18/17)/(L - 1/2) to the spoke from (1/4, y) to s, for all L >= 6, T in [2, 9/4] and H
        in (0, 9/17]: the degradation is above (17/18)(L - 1/2) and has no bound. It is above 45 from L = 49 on.
Method  the foot is on the spoke; the rest is a combination with nonnegative coefficients.
Tight   the distance times (L - 1/2) tends to (2 T - 1/2) H, that is 18/17 for T = 9/4 and H = 9/17: linear growth is
        all there is (`p6-gap.linear`).
By hand that P4 has these vertices for every L: only the two right ones move with L, and levels do not depend on it.
        The tests compare with the construction for several L, both spacings and both rules.
"""

from gmpy2 import mpq
from kit import Theorem, at_least, bounded, cross, dot, main, more, spot, square, states

from exactmesh.proofs.polynomial import variables

L, T, H = variables("L T H")
HYPOTHESES = (at_least(L, 6), at_least(T, 2), at_least(mpq(9, 4), T), more(H), at_least(mpq(9, 17), H))
SPOKE = spot(L / 2 - mpq(1, 4), H / 2)
FOOT = spot(T - mpq(1, 4), 0)
LENGTH, AREA = dot(SPOKE, SPOKE), cross(SPOKE, FOOT)
WIDE = L - mpq(1, 2)

STATEMENTS = [
    states("p6-gap.foot-after", "the foot of the T-vertex is not before the spoke", HYPOTHESES,
           more(dot(FOOT, SPOKE))),
    states("p6-gap.foot-before", "the foot of the T-vertex is not beyond the spoke", HYPOTHESES,
           more(LENGTH, dot(FOOT, SPOKE))),
    bounded("p6-gap.distance", "the T-vertex is nearer than (18/17)/(L - 1/2) to the spoke", HYPOTHESES,
            lambda f: more(mpq(18, 17)**2 * LENGTH / square(f), AREA * AREA * WIDE * WIDE)),
    states("p6-gap.above-45", "(17/18)(L - 1/2) is above 45 from L = 49 on", (at_least(L, 49),),
           more(mpq(17, 18) * WIDE, 45)),
    bounded("p6-gap.linear", "with H >= 10/21 the distance is above (4/5)/(L - 1/2)",
            (*HYPOTHESES, at_least(H, mpq(10, 21))),
            lambda f: more(AREA * AREA * WIDE * WIDE, square(f) * mpq(16, 25) * LENGTH)),
]
FAMILY = ("The vertices of P4 of the hexagon are given in L by hand: only the two right ones move with L, levels "
          "do not depend on it; the tests compare with the construction for several L, both spacings, both rules.")
TIGHT = "the distance times L - 1/2 tends to (2 T - 1/2) H <= 18/17: the growth is linear"

NAMES = tuple(statement.id for statement in STATEMENTS)
GROUP = "p6-gap"
THEOREMS = [
    Theorem("section-2.p6-degradation", "refuted", "the degradation grows with L without a bound", NAMES,
            FAMILY + " mfs(P5) does not decrease with L, because its vertices keep their places or move apart.", TIGHT),
    Theorem("section-2.interior-feature-size", "refuted", "the Interior keeps no constant", NAMES, FAMILY, TIGHT),
    Theorem("theorem-1.degradation", "refuted", "the published construction has no constant degradation", NAMES,
            FAMILY, TIGHT),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
