"""Prove I2 of the repaired construction: a vertex q of Q is 0.0599 away from each edge of Q that does not contain it.

Given   mfs 1 (m <= mfs). K1, K2 = K1 + S, S the vertical segment [-g/2, g/2]; rho the reach of K2. A cap vertex is
        p + k for k in K1, moved vertically by at most g/2. A convex vertex is the q for which q - K1 lies in the wedge
        of p and touches its sides, at w0 and w1; it moves vertically by at most g/2.
Claim   edge-sine: below 90 degrees the far end of e0 is at 1 or more from the line of e1.
        contact: w0 is on e0, not beyond: below 90 degrees |w0| sin < 1, as K1 is less than 1 wide; from 90 degrees on
        |w0| <= |w0 - w1| < 1, as K1 has a diameter below 1.
        So a convex vertex is in e0 + K2 and in e1 + K2, a cap vertex in p + K2, and e' in e + K2, which is convex.
        apart: |d| >= 1 and |k|, |k'| <= rho leave |d + k - k'| >= 1 - 2 rho.
        triangle: shifting the sides of a triangle of inradius 1 or more by up to 0.4701 leaves heights of 1.05, of
        which snapping takes g.
        octagon: a vertex of K1 is 0.15 or more from its other edges.
Method  see `offset.separation` for the number 1 - 2 rho, `caps` for a cap and the e' at its end.
Tight   `offset.separation`: 0.0599 where 0.05996 is true of the argument; 0.0646 is the least seen.
By hand the list of pairs (in `PAIRS`); that the sum of two convex sets is convex.
"""

from gmpy2 import mpq
from kit import Hint, Statement, Theorem, at_least, bounded, dot, equal, main, more, spot, square, states
from repaired_caps import OCTAGON
from repaired_caps import STATEMENTS as AT_A_CAP

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FLAT, GAP, LEVEL, THICKNESS_MAX, WIDE

a, b, c, s, t, x, y, D, r, R = variables("a b c s t x y D r R")
ANGLE = (equal(c * c + s * s, 1), more(s), at_least(c))
REACH_1 = WIDE**2 + LEVEL**2 / 4  # the square of the reach of K1


def octagon() -> list[Statement]:
    """Return that a vertex of K1 keeps 0.15 from its other edges."""
    found = []
    for turn in range(1, 7):
        for i in range(8):
            p, q, v = OCTAGON[(i + turn) % 8], OCTAGON[(i + turn + 1) % 8], OCTAGON[i]
            at = spot(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)).minus(v)
            found.append(bounded(
                f"separation.octagon-{i}-{turn}", f"vertex {i} of K1 and a point of the edge {turn} after it",
                (at_least(t), at_least(1, t)), lambda f, at=at: at_least(dot(at, at), square(f) * GAP**2),
                Hint(degrees=(2,), squares=(t, 1 - t))))
    return found


STATEMENTS = [
    states("separation.edge-sine-inside", "the foot of the far end of e0 is on e1", (
        *ANGLE, more(a), more(b), at_least(a, b * c), at_least((b * s)**2, 1)), at_least((b * s)**2, 1)),
    bounded("separation.edge-sine-beyond", "it is beyond e1: then that of e1 is on e0", (
        *ANGLE, more(a), more(b, a), at_least((a * s)**2, 1)),
            lambda f: at_least((b * s)**2, square(f)), Hint(degrees=(2, 3, 4), squares=(s,))),
    states("separation.longer", "where the foot is beyond e1, e0 is longer", (
        at_least(c), at_least(1, c), more(a), more(b), more(b * c, a)), more(b, a), Hint(degrees=(2, 3))),
    bounded("separation.width", "K1 is less than 1 wide: 2 n.k < 1 for |n| = 1", (
        equal(x * x + y * y, 1), at_least(x), at_least(y)),
            lambda f: more(1 / mpq(f), 2 * (x * WIDE + y * LEVEL / 2)),
            Hint(degrees=(2,), squares=(x - mpq(96, 100), y - mpq(27, 100), x * LEVEL / 2 - y * WIDE))),
    bounded("separation.width-upper", "and 2 n.k < 1 for the upper vertices",
            (equal(x * x + y * y, 1), at_least(x), at_least(y)),
            lambda f: more(1 / mpq(f), 2 * (x * FLAT + y * 3 * LEVEL / 2)),
            Hint(degrees=(2,), squares=(x - mpq(21, 100), y - mpq(98, 100), x * 3 * LEVEL / 2 - y * FLAT))),
    states("separation.obtuse", "from 90 degrees on, |w0| <= |w0 - w1|", (
        equal(c * c + s * s, 1), at_least(s), at_least(0, c), at_least(a), at_least(b)),
           at_least((a - b * c)**2 + (b * s)**2, a * a), Hint(degrees=(2, 3, 4), squares=(b,))),
    bounded("separation.diameter", "the diameter of K1 is below 1", (at_least(REACH_1, r), at_least(r)),
            lambda f: more(1 / square(f), 4 * r)),
    states("separation.back", "k = (x, y) with |k| <= rho has x >= -rho", (
        at_least(R), at_least(R * R, x * x + y * y)), at_least(x + R), Hint(degrees=(2,), squares=(y,))),
    bounded("separation.apart", "|d + k| >= |d| - rho, d = (D, 0), |k| <= rho", (
        at_least(D, R), at_least(x + R), at_least(R * R, x * x + y * y)),
            lambda f: at_least((D + x)**2 + y * y, square(f) * (D - R)**2),
            Hint(degrees=(2, 3), squares=(x + R, y)), {"D": "2", "R": "1", "x": "-1", "y": "0"}),
    bounded("separation.triangle", "2 (r - 0.4701) - g >= 0.0599 for an inradius r >= 1", (at_least(r, 1),),
            lambda f: at_least(2 * (r - THICKNESS_MAX) - LEVEL, mpq(599, 10000) * mpq(f))),
    *octagon(),
]
PAIRS = (
    "A vertex q of a corner at p, an edge f of Q without q. "
    "f = e', p not on e, q in a cap: p and e are 1 apart. "
    "f = e', p not on e, q convex: e is disjoint from e0 or from e1, unless the three are a triangle; disjoint edges "
    "are 1 apart, since the distance is attained at an end. "
    "In a triangle that is a face with something inside there is a vertex inside, 1 or more from all sides; the "
    "nearest point of the boundary is a foot on a side, so the inradius is 1 or more. "
    "f = e', p on e, e an edge of the corner: `caps`, where e' has the direction of e before snapping because it does "
    "not vanish while K1 grows from a point. f on a cap of the same corner: the octagon. "
    "f on a cap of another vertex p': p and p' are 1 apart; for a convex q, p' is not on e0 or not on e1. "
    "f of another corner at the same p: a segment to it from q leaves the wedge, through the line of e0 or e1, which "
    "is g away by `repaired.offset-thickness`.")
GROUP = "separation"
NAMES = tuple(statement.id for statement in STATEMENTS)
THEOREMS = [
    Theorem("repaired.offset-separation", "claim", "a vertex of Q keeps 0.0599 from the edges of Q without it",
            (*NAMES, "offset.separation", "offset.reaches", *(statement.id for statement in AT_A_CAP)), PAIRS,
            "0.0646 is the least that a search found"),
    Theorem("repaired.chord-leg", "claim", "a T-vertex keeps 0.0599 from the legs",
            (*NAMES, "offset.separation", "offset.reaches", *(statement.id for statement in AT_A_CAP)),
            "The case of `repaired.offset-separation` where the edge holds a leg: an edge that is not level meets the "
            "level of the T-vertex once, at a corner of the trapezoid. " + PAIRS, "0.0646 is the least that was seen"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
