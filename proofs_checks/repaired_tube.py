"""Prove that every face of the Tube keeps 0.0223, which is above mfs/45 (`repaired.tube-feature-45`).

Given   an edge e of P from A = (0,0) to B = (L,0), L >= 1, its offset edge e' above it, from D = (a,t) to C = (b,u).
        I1: t, u in [g, 0.4701]. Neighbours on e' are 0.134 apart; a level e' is 0.0688 long.
Claim   place  b > 0 and |AC| >= 0.5299, so b >= 0.244; a >= -0.4701; alike for B and D.
        tilt   an e' with vertices on it has a slope of 1/2 at most against e, and its vertices are 0.1198 apart along
               e; without, the slope is 3.38 at most.
        caps   the triangles of a cap keep 0.0464.
        split  (A, B, v) for a vertex v of e'.        fan    (A, v, w), both within h = min(t, u) of A along e.
        one    no vertex on e': if |t - u| >= 1/25 a diagonal, else the centre half way from the middle of e' to e.
        low    `nested_below`, leaders 4/5 h over e: tooth, between two teeth, end of the fan, (A, E, apex) and
               (A, z, B) with the T-vertices on their sides; there lengths are divided by h, T = 0.0223/h.
Method  Long triangles are over e, so they are those of a strip. Where e' comes in, twice the area is linear in the
        width of the gap and in the depth below e', at least h/5, of an apex: combinations. One problem a height.
By hand the positions and the list of cases (in `PLACES` and `CASES`). That the list is complete is checked by program:
        `tests/proofs/test_tube_cases.py` finds each face among the cases, with the hypotheses true of it.
"""

from collections.abc import Iterable

from gmpy2 import mpq
from kit import (
    Hint,
    Spot,
    Statement,
    Theorem,
    at_least,
    bounded,
    cross,
    dot,
    equal,
    keeps_distance,
    main,
    more,
    spot,
    square,
    states,
)
from repaired_caps import OCTAGON

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, Scalar, variables
from exactmesh.steps.constants import EDGE_GAP, FEATURE, LEVEL, LEVEL_EDGE, THICKNESS_MAX, TUBE_FEATURE

g, REACH = LEVEL, mpq(4247, 10000)
NEAR, BESIDE = 1 - THICKNESS_MAX, mpq(244, 1000)
ALONG, SLOPE, STEEP = mpq(1198, 10000), mpq(1, 2), mpq(338, 100)
SLANT, NARROW = mpq(1, 25), mpq(559, 10000)
CENTRE = mpq(1759, 10000)
names = "L a b c d e f h k n p q r s t u x y z D X T"
L, a, b, c, d, e, f, h, k, n, p, q, r, s, t, u, x, y, z, D, X, T = variables(names)
A = spot(0, 0)
SHORT, LONG = Hint(degrees=(2, 3, 4)), Hint(degrees=(2, 3, 4, 5, 6))


def within(value: Scalar, low: Scalar, high: Scalar) -> tuple[Constraint, Constraint]:
    """Return low <= value <= high."""
    return at_least(value, low), at_least(high, value)


def height(id_: str, says: str, given: Iterable[Constraint], area: Polynomial, side: Spot,
           target: Scalar = TUBE_FEATURE, hint: Hint = SHORT) -> Statement:
    """Return that the height over a side is the target or more, by twice the area."""
    return bounded(id_, says, given, lambda factor: at_least(area * area, square(factor) * target * target
                                                             * dot(side, side)), hint)


def triangle(id_: str, says: str, given: tuple[Constraint, ...], corners: tuple[Spot, ...],
             target: Scalar = TUBE_FEATURE, hint: Hint = LONG) -> list[Statement]:
    """Return that a triangle is counter-clockwise and its heights are the target or more."""
    area = cross(corners[1].minus(corners[0]), corners[2].minus(corners[0]))
    return [states(f"{id_}.area", f"{says}: counter-clockwise", given, more(area), hint),
            *(height(f"{id_}.height-{i + 1}", f"{says}: the height from corner {i + 1}", given, area,
                     corners[i - 1].minus(corners[i - 2]), target, hint) for i in range(3))]


ANGLE = (equal(c * c + s * s, 1), more(s), at_least(c))
PLACE = [
    states("slanted.place-acute", "c, s of the angle at B, below 90 degrees: C is at most 0.4701 from the line of the "
           "next edge, A at 1 or more", (*ANGLE, at_least(L * s, 1), *within(u, g, THICKNESS_MAX),
                                    at_least(THICKNESS_MAX, (L - b) * s - u * c)), more(b), Hint(degrees=(2, 3))),
    states("slanted.place-obtuse", "c, s of the turn at B, up to 90 degrees: before snapping C is x before B along e; "
           "p, q the parts of the extreme k of the next edge across and along e, n that of the extreme k of e",
           (*ANGLE, at_least(n, p), at_least(REACH, q), equal(x * s, c * (p - n) + s * q)), at_least(REACH, x),
           Hint(degrees=(2, 3))),
    states("slanted.place-snapped", "so C is beyond A, snapped by g/2", (
        at_least(L, 1), at_least(REACH, x), at_least(b, L - x - g / 2)), more(b)),
    states("slanted.place-cap", "C is of a cap at B, or of a common k", (
        at_least(L, 1), at_least(THICKNESS_MAX, L - b)), more(b)),
    bounded("slanted.place-beside", "|AC| >= 0.5299", (more(b), *within(u, g, THICKNESS_MAX),
                                                    at_least(b * b + u * u, NEAR**2)),
            lambda m: at_least(b, BESIDE * mpq(m)), Hint(degrees=(2,), squares=(b - BESIDE,))),
]
# e' is (x, z), before snapping it was (x, y).
SNAPPED = (at_least(x), at_least(y), *within(y - z, -g, g))


def tilt(id_: str, says: str, given: Iterable[Constraint], slope: mpq, hint: Hint = SHORT
         ) -> list[Statement]:
    """Return that (x, z) has that slope at most against (x, y), to either side."""
    return [bounded(f"{id_}-{way}", f"{says}; e' {way}", (*SNAPPED, *given),
                    lambda m, turn=turn: at_least(slope * (x * x + y * z), mpq(m) * x * turn), hint)
            for way, turn in (("rises", z - y), ("falls", y - z))]


TILT = [
    *tilt("slanted.tilt-chord", "over two levels or more", (at_least(z, 2 * g),), SLOPE,
          Hint(degrees=(2, 3), squares=(x - z, x - y, x - 2 * g, y - z))),
    *tilt("slanted.tilt-foot", "flatter than 1/2", (at_least(z, g), at_least(x, 2 * z)), SLOPE),
    *tilt("slanted.tilt-step", "over a level or more, 0.1506 long before", (
        at_least(z, g), at_least(x * x + y * y, mpq(1506, 10000)**2)), STEEP,
          Hint(degrees=(2, 3, 4), squares=(x - y, x, y, x - mpq(15, 100)))),
    bounded("slanted.tilt-level", "level", (at_least(x, LEVEL_EDGE), *within(y, 0, g)),
            lambda m: at_least(STEEP * x, mpq(m) * y)),
    bounded("slanted.tilt-before", "its ends differ from points that are 1 apart by 2 k at most", (
        at_least(D, 1), *within(r, 0, 2 * REACH)), lambda m: at_least(D - r, mpq(m) * mpq(1506, 10000))),
    bounded("slanted.tilt-gap", "neighbours on e'", (at_least(x), *within(s, -SLOPE, SLOPE),
                                                  at_least(x * x * (1 + s * s), EDGE_GAP**2)),
            lambda m: at_least(x, ALONG * mpq(m)), Hint(degrees=(2, 3, 4))),
]
SHIFT = within(s, -g / 2, g / 2)
CAPS = [statement for name, i in (("side", 0), ("slant", 1), ("top", 2)) for statement in triangle(
    f"slanted.cap-{name}", f"a cap: its {name} edge, the corner s below the middle of K1", SHIFT,
    (spot(0, -s), OCTAGON[i], OCTAGON[i + 1]), FEATURE)]
HIGH = within(y, g, THICKNESS_MAX)
SPLIT = triangle("slanted.split", "(A, B, v)", (at_least(L, 1), *HIGH, *within(x, -THICKNESS_MAX, L + THICKNESS_MAX)),
                 (A, spot(L, 0), spot(x, y)), FEATURE)
# The fan: v = (x, y), w is q farther along e; e' has the slope s and passes c above A.
GAP, LEAN = at_least(q, ALONG), within(s, -SLOPE, SLOPE)
FAN = [
    bounded("slanted.fan-right", "v right of A: the line of e' is 0.1759 above A", (
        *within(h, g, THICKNESS_MAX), at_least(y, h), at_least(x), at_least(h, x + ALONG), *LEAN),
            lambda m: at_least(y - s * x, CENTRE * mpq(m)), Hint(degrees=(2, 3))),
    states("slanted.fan-over", "v left of A: it is h or more", (at_least(h, g),), at_least(h, CENTRE)),
    height("slanted.fan-apex", "(A, v, w): the height from A", (*LEAN, at_least(c, CENTRE)), c, spot(1, s)),
    height("slanted.fan-side", "(A, v, w): the height over A-v or A-w", (
        GAP, at_least(c, CENTRE), *within(x, -THICKNESS_MAX, THICKNESS_MAX), *within(y, 0, THICKNESS_MAX)),
           q * c, spot(x, y)),
]
# One gap. Up to reflection u >= t; X = L - a, d = b - a, r = u - t; from the foot of D on e.
CLEAN = (*within(t, g, THICKNESS_MAX), *within(t + r, g, THICKNESS_MAX), at_least(d),
         at_least(d * d + r * r, LEVEL_EDGE**2))
SLANTED = (*CLEAN, at_least(r, SLANT), at_least(STEEP * d, r), at_least(X, BESIDE), at_least(X - d, -THICKNESS_MAX))
ONE = triangle("slanted.one-slanted", "(B, C, D), e' rising by 1/25 or more", SLANTED,
               (spot(X, 0), spot(d, t + r), spot(0, t)))
FLAT = (*CLEAN, *within(r, -SLANT, SLANT))
ONE += [bounded("slanted.one-wide", "e' rising by less", FLAT, lambda m: at_least(d, NARROW * mpq(m)),
                Hint(degrees=(2,), squares=(d - NARROW, r)))]
WIDE = (*within(t, g, THICKNESS_MAX), *within(t + r, g, THICKNESS_MAX), at_least(d, NARROW), *within(r, -SLANT, SLANT))
middle = spot(d / 2, (2 * t + r) / 4)
ONE += triangle("slanted.one-above", "(z, C, D), z the centre", WIDE, (middle, spot(d, t + r), spot(0, t)))
centre = spot(a + d / 2, (2 * t + r) / 4)
ONE += triangle("slanted.one-right", "(A, z, D), D right of A", (*WIDE, at_least(a), at_least(a + d, BESIDE)),
                (A, centre, spot(a, t)))
ONE += triangle("slanted.one-left", "(A, z, D), D left of A", (
    *WIDE, *within(a, -THICKNESS_MAX, 0), at_least(a + d, BESIDE)), (A, centre, spot(a, t)))
ONE += triangle("slanted.one-below", "(A, B, z)", (*within(y, g / 2, THICKNESS_MAX), at_least(L, 1),
                                               *within(x, -THICKNESS_MAX, L + THICKNESS_MAX)),
                (A, spot(L, 0), spot(x, y)))
# nested_below. An apex is d below e'.
DEEP = at_least(d, g / 5)
LOW = [
    height("slanted.low-tooth-apex", "a tooth, d deep: the height from its apex", (*LEAN, DEEP), d, spot(1, s)),
    height("slanted.low-tooth-side", "a tooth over a gap q, its apex p along: the height over a side", (
        GAP, *LEAN, DEEP, *within(p, 0, q)), q * d, spot(p, s * p - d)),
]
BETWEEN = (at_least(p, ALONG / 2), at_least(q, ALONG / 2), *LEAN, DEEP, at_least(r, g / 5))
LOW += [
    height("slanted.low-between-side", "two apexes, p and q beside v, d and r deep: the height over v-apex", BETWEEN,
           p * r + q * d, spot(p, s * p + d)),
    height("slanted.low-between-above", "the height from v", BETWEEN, p * r + q * d, spot(p + q, s * (p + q) + d - r)),
]
# The end of the fan, v = (x, y), and the first apex (p, r).
FIRST = (*within(h, g, THICKNESS_MAX), *within(y, h, THICKNESS_MAX), at_least(2 * p, h), *within(5 * r, 0, 4 * h),
         at_least(p - x, ALONG / 2))
LOW += triangle("slanted.low-end-right", "(A, apex, v), v right of A", (*FIRST, at_least(x)),
                (A, spot(p, r), spot(x, y)))
LOW += triangle("slanted.low-end-left", "(A, apex, v), v left of A", (*FIRST, *within(x, -THICKNESS_MAX, 0)),
                (A, spot(p, r), spot(x, y)))
LOW += [
    states("slanted.low-place", "an apex is at least h/2 from A: k is the inset, x the right end of the gap",
           (at_least(x, h), at_least(h, 2 * k)), at_least(2 * (x - k), h)),
    states("slanted.low-middle", "so is the middle of e", (at_least(L, 1), *within(h, g, THICKNESS_MAX)),
           at_least(L, h)),
    states("slanted.low-fans", "the fans do not meet", (at_least(L, 1), *within(h, g, THICKNESS_MAX)), more(L, 2 * h)),
    states("slanted.low-inset", "insets are half the least gap or more", (GAP, at_least(h, g)), at_least(h, ALONG)),
]
# From here on lengths are divided by h. E = (e, 4/5) leads, the next leader beyond is at f.
UP, K = mpq(4, 5), mpq(53, 10)
SMALL = (more(T), at_least(TUBE_FEATURE / g, T))
LEADERS = (*SMALL, at_least(2 * e, 1), at_least(f, 2 * e))
OF_FAR, OF_GROUP = within(x, mpq(1, 2), 1), within(y, mpq(1, 2), 1)
E, on_far, member = spot(e, UP), spot(x * f, UP * x), spot(y * e, UP * y)
APART = at_least(e - y * e, K * T)
LOW += triangle("slanted.low-long", "(A, E, apex), the apex on A-F beyond f/2", (*LEADERS, *OF_FAR), (A, on_far, E), T)
LOW += [height("slanted.low-member", "a member of the group of E against A-F", (*LEADERS, *OF_GROUP),
               cross(spot(f, UP), member), spot(f, UP), T, Hint(degrees=(4, 5, 6)))]
LOW += keeps_distance("slanted.low-member-apex", "a member, a gap before E, against E-apex",
                      (*LEADERS, *OF_FAR, *OF_GROUP, APART), member, E, on_far, T * T, Hint(degrees=(4, 5, 6)))
TOP = (*SMALL, at_least(2 * e, 1), at_least(2 * (D - e), 1), at_least(D, 2))
LOW += triangle("slanted.low-top", "(A, B, z)", TOP, (A, spot(D, 0), E), T)
LOW += [bounded("slanted.low-top-below", "a member against A-B", (*SMALL, *OF_GROUP),
                lambda m: at_least(UP * y, mpq(m) * T))]
LOW += keeps_distance("slanted.low-top-member", "a member, a gap before z, against z-B", (*TOP, *OF_GROUP, APART),
                      member, E, spot(D, 0), T * T, Hint(degrees=(4, 5, 6)))
STATEMENTS = [*PLACE, *TILT, *CAPS, *SPLIT, *FAN, *ONE, *LOW]

PLACES = (
    "Corners of the walk at B. A cap, a common k, a slit end: C is in B + K2, within 0.4701 of B. A crossing k0, k1 "
    "below 90 degrees: by `separation.edge-sine` A is at 1 or more from the line of the next edge, C by I1 at most "
    "0.4701. From 90 degrees on C is x before B along e, x s = n1.k1 - c n.k, where n1 = c n + s (the direction of e) "
    "up to sign. So C is not behind A. As A is not on the next edge, C is in the sum of K2 and of what is 1 or more "
    "from A: |AC| >= 0.5299. D is in e + K2. An e' with vertices on it is not level; it carries a chord end, and then "
    "rises by two levels or more, or a foot, and then has a slope below 1/2. Rounding changes dy by less than g, and "
    "the sign of dy weakly. Without: level, 0.0688 long by `gaps.edge-side`, `gaps.edge-upper`; or not, and before "
    "snapping it was 0.1506 long. In a triangle with something inside edges were over 1 long. ")
CASES = (
    "Every candidate is measured, and the best is taken unless one has 0.0464; so one good candidate is enough. Caps: "
    "one triangle an edge (`repaired.caps-whole`). No vertex on e': |t - u| >= 1/25, the split at the higher end's "
    "far anchor, `split` and `one-slanted`; else the centre at half height. With vertices on e': all are within h of "
    "A, the split at C: `fan`, `split`; or of B; else nested_below exists, as the fans do not meet. "
    "tests/proofs/test_tube_cases.py finds each of its faces among: fan, tooth, between, end, long, top, or mirrored, "
    "with the hypotheses true, for all groupings of few apexes and at random. T-vertices of long faces are members, a "
    "gap before their leader. |t - u| and all else is symmetric in A and B.")
CITED = ("separation.edge-sine-inside", "separation.edge-sine-beyond", "separation.longer", "separation.back",
         "separation.apart", "offset.thickness-upper", "offset.thickness-side", "offset.reach-upper",
         "offset.reach-side", "gaps.reach", "gaps.reach-upper", "gaps.edge-side", "gaps.edge-upper",
         "levels.cap-chord", "levels.cap-foot")
GROUP = "slanted"
THEOREMS = [Theorem(
    "repaired.tube-feature-45", "claim", "every face of the Tube keeps 0.0223 mfs",
    (*(statement.id for statement in STATEMENTS), *CITED), PLACES + CASES, "0.046 is the least that a search found")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
