"""Prove that every face of the Tube keeps f* = g/5 = 0.0464 (`repaired.tube-feature`, `repaired.tube-feature-45`).

Given   an edge e of P from A = (0,0) to B = (L,0), L >= 1, its offset edge e' above it, from D = (a,t) to C = (b,u).
        I1: t, u in [g, 0.4701]. Neighbours on e' are 0.134 apart; a level e' is 0.0688 long.
Claim   place  b > 0 and |AC| >= 0.5299, so b >= 0.244 and b + u >= 0.708; a >= -0.4701; where a < 0, |AD| <= 0.4701;
               alike for B.
        tilt   an e' with vertices on it has a slope of 1/2 at most against e, and its vertices are 0.1198 apart along
               e; without, the slope is 3.38 at most.
        caps   the triangles of a cap.                split  (A, B, v) for a vertex v of e'.
        fan    (A, v, w), both within h = min(t, u) of A along e.
        one    no vertex on e': a diagonal, or the star of one z, 0.7 of the way down from the middle of e' to e, or
               half way at a right angle to e'.
        low    `nested_below`, leaders h (4/5 - s^2/10) over e, s the slope of e': tooth, between two teeth, end of the
               fan, (A, E, apex) and (A, z, B) with the T-vertices on their sides; there in units of h, T = f*/h.
Method  Long triangles are over e, so they are those of a strip. Members keep h/5 from the line of the leader beyond by
        the rule that groups them; leaders by induction: e^2 <= D^2 + 1/2 for leaders at e and e + D. Where e' comes in,
        twice the area is linear in the width of a gap and in the depth of an apex, and a side is at most the
        sum of how far it goes across and up. Combinations, one problem a height.
Tight   low: a leader of a level strip stands h/5 under e', and h = g is attained.
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
from exactmesh.proofs.polynomial import Polynomial, Scalar, polynomial, variables
from exactmesh.steps.constants import EDGE_GAP, FEATURE, LEVEL, LEVEL_EDGE, THICKNESS_MAX

g, REACH = LEVEL, mpq(4247, 10000)
NEAR, BESIDE, SUM = 1 - THICKNESS_MAX, mpq(244, 1000), mpq(708, 1000)
ALONG, SLOPE, STEEP = mpq(1198, 10000), mpq(1, 2), mpq(338, 100)
NARROW = mpq(535, 10000)
L, a, b, c, d, e, h, k, n, p, q, r, s, t, u = variables("L a b c d e h k n p q r s t u")
v, w, x, y, z, D, G, X, T = variables("v w x y z D G X T")
A = spot(0, 0)
SHORT, LONG = Hint(degrees=(2, 3, 4)), Hint(degrees=(2, 3, 4, 5, 6))


def within(value: Scalar, low: Scalar, high: Scalar) -> tuple[Constraint, Constraint]:
    """Return low <= value <= high."""
    return at_least(value, low), at_least(high, value)


def height(id_: str, says: str, given: Iterable[Constraint], area: Polynomial, side: Spot,
           target: Scalar = FEATURE, hint: Hint = SHORT) -> Statement:
    """Return that the height over a side is the target or more, by twice the area."""
    return bounded(id_, says, given, lambda factor: at_least(area * area, square(factor) * target * target
                                                             * dot(side, side)), hint)


def tall(id_: str, says: str, given: Iterable[Constraint], area: Polynomial, across: Scalar, up: Scalar) -> Statement:
    """Return that the height over a side is 0.0464 or more, by how far the side goes across and up, together."""
    return bounded(id_, says, given, lambda factor: at_least(area, mpq(factor) * FEATURE * (up + polynomial(across))),
                   SHORT)


def triangle(id_: str, says: str, given: tuple[Constraint, ...], corners: tuple[Spot, ...],
             target: Scalar = FEATURE, hint: Hint = LONG) -> list[Statement]:
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
    states("slanted.place-ahead", "below 90 degrees at A, D is beyond A: it is g from the edge before",
           (*ANGLE, *within(t, g, THICKNESS_MAX), at_least(a * s - t * c, g)), more(a), Hint(degrees=(2, 3))),
    states("slanted.place-inside", "from 90 degrees on D is at least as far along as k = (q, n), extreme for "
           "e; p = n1.k1 is at least n1.k", (more(s), at_least(p, c * n + s * q), equal(x * s, p - c * n)),
           at_least(x, q), SHORT),
    states("slanted.place-behind", "so D behind A is no farther from A than k snapped, (q, t)",
           (at_least(0, a), at_least(a, q), at_least(THICKNESS_MAX**2, q * q + t * t)),
           at_least(THICKNESS_MAX**2, a * a + t * t), SHORT),
    bounded("slanted.place-beside", "|AC| >= 0.5299", (more(b), *within(u, g, THICKNESS_MAX),
                                                    at_least(b * b + u * u, NEAR**2)),
            lambda m: at_least(b, BESIDE * mpq(m)), Hint(degrees=(2,), squares=(b - BESIDE,))),
    bounded("slanted.place-sum", "b + u, too", (more(b), *within(u, g, THICKNESS_MAX),
                                                at_least(b * b + u * u, NEAR**2)),
            lambda m: at_least(b + u, SUM * mpq(m)), SHORT),
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
                 (A, spot(L, 0), spot(x, y)))
# The fan: w is q beyond v along e, (x, y) is one of the two; e' has the slope s and passes c above A.
GAP, LEAN, H = at_least(q, ALONG), within(s, -SLOPE, SLOPE), within(h, g, THICKNESS_MAX)
FAN = [
    bounded("slanted.fan-right", "v = (x, y) right of A: how far the line of e' is above A", (
        *H, at_least(y, h), at_least(x), at_least(h, x + ALONG), *LEAN),
            lambda m: at_least(2 * (y - s * x), (h + ALONG) * mpq(m)), SHORT),
    states("slanted.fan-over", "v left of A: h or more", (*H, at_least(c, h)), at_least(2 * c, h + ALONG)),
    height("slanted.fan-apex", "(A, v, w): the height from A", (*LEAN, *H, at_least(2 * c, h + ALONG)), c, spot(1, s)),
    height("slanted.fan-behind", "(A, v, w): the height over the side to one left of A", (
        GAP, *H, at_least(c, h), at_least(THICKNESS_MAX**2, x * x + y * y)), q * c, spot(x, y)),
    height("slanted.fan-ahead", "(A, v, w): the height over the side to one right of A", (
        GAP, *LEAN, *H, at_least(2 * c, h + ALONG), *within(x, 0, h), at_least(THICKNESS_MAX, c + s * x)),
           q * c, spot(x, c + s * x), FEATURE, LONG),
]
# One gap. Up to reflection u >= t; X = L - a, d = b - a, r = u - t; from the foot of D on e.
ENDS = (*within(t, g, THICKNESS_MAX), *within(t + r, g, THICKNESS_MAX))
CLEAN = (*ENDS, at_least(d), at_least(d * d + r * r, LEVEL_EDGE**2), at_least(X, BESIDE),
         at_least(X + t, SUM), at_least(X - d, -THICKNESS_MAX))
to_b = spot(X, 0), spot(d, t + r), spot(0, t)
SLANTED = (*CLEAN, at_least(r, FEATURE), at_least(STEEP * d, r))
ONE = triangle("slanted.one-slanted", "(B, C, D), e' rises by 0.0464 or more", SLANTED, to_b)[:2]
ONE += [tall("slanted.one-slanted-back", "the height over BC, B left of C", (*SLANTED, at_least(d, X)), d * t + X * r,
             d - X, t + r)]
for side, ahead, across, up in (("bc", (at_least(X, d),), X - d, t + r), ("bd", (), X, t)):
    steep = (*SLANTED, *ahead, at_least(FEATURE, d))
    ONE += [
        tall(f"slanted.one-slanted-{side}-wide", f"the height over {side}, e' 0.0464 wide or more",
             (*SLANTED, *ahead, at_least(d, FEATURE)), d * t + X * r, across, up),
        tall(f"slanted.one-slanted-{side}-steep", f"the height over {side}, e' less wide", steep, d * t + X * r, across,
             mpq(62, 100) * up),
        states(f"slanted.one-slanted-{side}-far", "there B is more than half as far beside it as it is high", steep,
               at_least(2 * polynomial(across), up), SHORT),
    ]
ONE += [states("slanted.one-slanted-side", "so that side is so short", (at_least(y), at_least(2 * x, y)),
               at_least((x + mpq(62, 100) * y)**2, x * x + y * y), SHORT)]
SHORT_EDGE = (*CLEAN, *within(r, 0, FEATURE), at_least(NARROW, d))
ONE += triangle("slanted.one-near", "(B, C, D), e' rises by less, is short, B is near", (*SHORT_EDGE, at_least(2, X)),
                to_b)
# The star of z, d/2 + j beyond D: half way to e, at a right angle to e', or 0.7 of the way straight down.
ONE += [
    bounded("slanted.one-shift", "how far the foot of z is from the middle of e'; k e' turned leads to z", (
        *SHORT_EDGE, at_least(k), equal(4 * d * k, 2 * t + r)), lambda m: at_least(mpq(1, 4) / mpq(m), r * k)),
    height("slanted.one-far-base", "(z, C, D), z is y from e', of length p: the height from z", (at_least(y, g / 2),),
           y, spot(1, 0)),
    height("slanted.one-far-side", "the height over another side", (at_least(y, g / 2), at_least(p, LEVEL_EDGE)),
           p * y, spot(p / 2, y)),
]
shifted = (*ENDS, *within(r, 0, FEATURE), *within(d, mpq(5, 100), NARROW), *within(x, 0, mpq(1, 4)))
half, low = (2 * t + r) / 4, 3 * (2 * t + r) / 20
RIGHT = (at_least(a), at_least(a + d, BESIDE))


def beside(id_: str, says: str, given: tuple[Constraint, ...], shift: Scalar, up: Polynomial) -> list[Statement]:
    """Return the heights of (A, z, D), D right of A; `up` is how high z is."""
    area, z_x = (a + d / 2 + shift) * t - a * up, a + d / 2 + shift
    return [tall(f"{id_}-{side}", f"{says}: the height over {side}", (*given, *RIGHT), area, across, rise)
            for side, across, rise in (("ad", a, t), ("az", z_x, up), ("dz", d / 2 + shift, t - up))]


ONE += beside("slanted.one-far-right", "(A, z, D)", shifted, x, half)
ONE += triangle("slanted.one-far-b", "(B, C, z)", (*shifted, at_least(X, 2)),
                (spot(X, 0), spot(d, t + r), spot(d / 2 + x, half)))
FLAT = (*ENDS, *within(r, -FEATURE, FEATURE), at_least(d, NARROW))
ONE += triangle("slanted.one-above", "(z, C, D), z straight down", FLAT, (spot(d / 2, low), spot(d, t + r), spot(0, t)))
ONE += beside("slanted.one-right", "(A, z, D), D right of A", FLAT, 0, low)
LEFT = (*FLAT, *within(a, -THICKNESS_MAX, 0), at_least(THICKNESS_MAX**2, a * a + t * t), at_least(a + d + t + r, SUM))
ONE += [
    bounded("slanted.one-left-ad", "(A, z, D), D left of A: the height over AD, which is 0.4701 at most", LEFT,
            lambda m: at_least((a + d / 2) * t - a * low, mpq(m) * FEATURE * THICKNESS_MAX), LONG),
    tall("slanted.one-left-dz", "the height over dz", LEFT, (a + d / 2) * t - a * low, d / 2, t - low),
    tall("slanted.one-left-az", "the height over Az, which goes across by d/2 at most", LEFT,
         (a + d / 2) * t - a * low, d / 2, low),
]
ONE += triangle("slanted.one-below", "(A, B, z)", (*within(y, 3 * g / 10, THICKNESS_MAX), at_least(L, 1),
                                                  *within(x, -mpq(12, 100), L + mpq(12, 100))),
                (A, spot(L, 0), spot(x, y)))
# nested_below. An apex is d below e'. Beside p along e, e' goes p (1 + s^2/2) at most.
ALONG_E = 1 + s * s / 2
DEEP = (at_least(d, FEATURE * ALONG_E), at_least(d, FEATURE))
LOW = [
    states("slanted.low-depth", "an apex, at most h (4/5 - s^2/10) high, below e', y high", (
        *H, at_least(y, h), at_least(h * (mpq(4, 5) - s * s / 10), r)), at_least(y - r, FEATURE * ALONG_E),
           Hint(degrees=(3,), squares=(s,))),
    states("slanted.low-slope", "the root of 1 + s^2 is 1 + s^2/2 at most", LEAN, at_least(ALONG_E**2, 1 + s * s),
           Hint(degrees=(4,), squares=(s * s,))),
    bounded("slanted.low-tooth-apex", "a tooth, d deep: the height from its apex", (*LEAN, *DEEP),
            lambda m: at_least(d, mpq(m) * FEATURE * ALONG_E), SHORT),
    tall("slanted.low-tooth-side", "a tooth over a gap q, its apex p along: the height over a side, p along e' and d",
         (*LEAN, *DEEP, at_least(p), at_least(q, p + ALONG / 2)), q * d, p * ALONG_E, d),
]
BETWEEN = (at_least(p, ALONG / 2), at_least(q, ALONG / 2), *LEAN, *DEEP, at_least(r, FEATURE * ALONG_E))
LOW += [
    tall("slanted.low-between-side", "two apexes, p and q beside v, d and r deep: the height over v-apex, p along e' "
         "and d", BETWEEN, p * r + q * d, p * ALONG_E, d),
    tall("slanted.low-between-above", "the height from v, over p + q along e' and d - r; d is the greater depth",
         (*BETWEEN, at_least(d, r)), p * r + q * d, (p + q) * ALONG_E, d - r),
]
# The end of the fan, v = (x, y), and the first apex (p, r).
FIRST = (*H, *within(y, h, THICKNESS_MAX), at_least(2 * p, h), *within(r, 38 * h / 100, 4 * h / 5),
         at_least(p - x, ALONG / 2))
LOW += triangle("slanted.low-end-right", "(A, apex, v), v right of A", (*FIRST, at_least(x)),
                (A, spot(p, r), spot(x, y)))
LOW += triangle("slanted.low-end-left", "(A, apex, v), v left of A", (
    *FIRST, at_least(0, x), at_least(THICKNESS_MAX**2, x * x + y * y)), (A, spot(p, r), spot(x, y)))
LOW += [
    states("slanted.low-place", "an apex is at least h/2 from A: k is the inset, x the right end of the gap",
           (at_least(x, h), at_least(h, 2 * k)), at_least(2 * (x - k), h)),
    states("slanted.low-middle", "so is the middle of e", (at_least(L, 1), *H), at_least(L, h)),
    states("slanted.low-fans", "the fans do not meet", (at_least(L, 1), *H), more(L, 2 * h)),
    states("slanted.low-inset", "insets are half the least gap or more", (GAP, at_least(h, g)), at_least(h, ALONG)),
]
# From here on lengths are divided by h. E = (e, c) leads, c = 4/5 - s^2/10; the next leader beyond is D farther out.
K, SUNK = mpq(258, 100), mpq(1054, 10000)
SMALL = (*within(T, mpq(987, 10000), mpq(1, 5)), *within(c, mpq(31, 40), mpq(4, 5)))
RATIO = (at_least(D), at_least(D * D + mpq(1, 2), e * e))
LOW += [
    states("slanted.low-scale", "0.0464/h is 0.0987 or more and 1/5 or less", (*H, equal(T * h, FEATURE)),
           at_least(T, mpq(987, 10000)), SHORT),
    states("slanted.low-gap", "a gap is 2.58 T: 0.1198/h", (*H, equal(T * h, FEATURE), at_least(x * h, ALONG)),
           at_least(x, K * T), SHORT),
    states("slanted.low-sunk", "how low c is: e' rises by 0.2381 at most over D", (
        more(D), *within(s, 0, SLOPE), equal(c, mpq(4, 5) - s * s / 10), *H, at_least(THICKNESS_MAX - h, s * D * h)),
           at_least(c * D * D, mpq(4, 5) * D * D - SUNK), LONG),
    states("slanted.low-ratio-first", "e is at most half as far out", (at_least(e), at_least(D, e)), at_least(D, e)),
    states("slanted.low-ratio-near", "the leader beyond is at 1 or less, a gap beyond", (
        at_least(e), *within(e + D, 0, 1), at_least(D, K * mpq(987, 10000))), RATIO[1], SHORT),
    states("slanted.low-ratio-sum", "e and D together", RATIO, at_least(4 * D * D + 1, (e + D)**2),
           Hint(degrees=(2,), squares=(e - D,))),
    states("slanted.low-ratio-next", "v is y^2, y e the place of the next leader, w is D^2, q is e^2", (
        at_least(w, mpq(1, 2)), at_least(y), at_least(q, 1), at_least(w + mpq(1, 2), q),
        more((2 * y - 1) * q, mpq(1, 2))), at_least(y * y * (4 * w + 2), w + mpq(3, 2)),
           Hint(degrees=(2, 3, 4), squares=(2 * y - 1,))),
    states("slanted.low-ratio-kept", "then that leader keeps 1/5 from the line of the one beyond E, so it is none", (
        at_least(w, mpq(1, 2)), *SMALL[2:], at_least(c * w, mpq(4, 5) * w - SUNK)),
           at_least(25 * c * c * w * (w + mpq(3, 2)), (4 * w + 1 + c * c) * (4 * w + 2)),
           Hint(cases=(at_least(w, 2),), degrees=(4, 5, 6))),
]
LEADERS = (*SMALL, at_least(2 * e, 1), *RATIO)
OF_FAR, OF_GROUP = (*within(x, mpq(1, 2), 1), at_least(x * (e + D) - e, K * T)), within(y, mpq(1, 2), 1)
E, on_far, member = spot(e, c), spot(x * (e + D), c * x), spot(y * e, c * y)
APART = at_least(e - y * e, K * T)
DEEPER = Hint(degrees=(4, 5, 6))
area, first, *_ = triangle("slanted.low-long", "(A, apex, E), the apex on A-F, half as far out or more",
                           (*LEADERS, *OF_FAR), (A, on_far, E), T)
LOW += [area, first, bounded("slanted.low-long.height-2", "the height from the apex over A-E", (*LEADERS, *OF_FAR),
                             lambda m: at_least(c * x * D, mpq(m) * T * (e + c)), DEEPER)]
LOW += [bounded("slanted.low-long.height-3", "the height from E over A-F, which goes e + D across", (
    *SMALL, at_least(D, K * T)), lambda m: at_least(c * c * D * D, square(m) * T * T * (4 * D * D + 1 + c * c)),
                Hint(cases=(at_least(2 * D, 1),), degrees=(4, 5, 6)))]
# From E, its apex is at (G, -c (1 - x)), a member at -v (e, c).
SIDE = (*SMALL, at_least(G, K * T), *within(w, 0, mpq(1, 2)), at_least(2 * e, 1))
LOW += [
    states("slanted.low-member-foot", "where the foot of a member is on E-apex, e is small",
           (*SIDE, at_least(c * c * w, e * G)), at_least(mpq(3, 2), e), SHORT),
    bounded("slanted.low-member-apex", "then the member is T from the line", (
        *SIDE, at_least(mpq(3, 2), e), at_least(v), at_least(v * e, K * T)),
            lambda m: at_least(v * c * (e * w + G), mpq(m) * T * (G + c * w)), DEEPER),
    bounded("slanted.low-member-end", "elsewhere it is as far as along e from E, or from the apex",
            (*SIDE, at_least(v * e, K * T)), lambda m: at_least(v * e, mpq(m) * T), SHORT),
]
TOP = (*SMALL, at_least(2 * e, 1), at_least(2 * (D - e), 1), at_least(D, 2))
LOW += triangle("slanted.low-top", "(A, B, z)", TOP, (A, spot(D, 0), E), T)
LOW += [bounded("slanted.low-top-below", "a member against A-B", (*SMALL, *OF_GROUP),
                lambda m: at_least(c * y, mpq(m) * T))]
LOW += keeps_distance("slanted.low-top-member", "a member, a gap before z, against z-B", (*TOP, *OF_GROUP, APART),
                      member, E, spot(D, 0), T * T, DEEPER)
STATEMENTS = [*PLACE, *TILT, *CAPS, *SPLIT, *FAN, *ONE, *LOW]

PLACES = (
    "Corners of the walk at B. A cap, a common k, a slit end: C is in B + K2, within 0.4701 of B. A crossing of the "
    "lines of e + k and e1 + k1 below 90 degrees: by `separation.edge-sine` A is at 1 or more from the line of e1, C "
    "by I1 at most 0.4701. From 90 degrees on C is x before B along e, x s = n1.k1 - c n.k, where n1 = c n + s (the "
    "direction of e, up to sign). So C is not behind A. As A is not on e1, C is in the sum of K2 and of what is 1 or "
    "more from A: |AC| >= 0.5299. D is in e + K2. An e' with vertices on it is not level; it carries a chord end, and "
    "then rises by two levels or more, or a foot, and then its slope is below 1/2. Rounding changes dy by less than "
    "g, and the sign of dy weakly. Without: level, 0.0688 long by `gaps.edge-side`, `gaps.edge-upper`; or not, and "
    "before snapping it was 0.1506 long. In a triangle with something inside edges were over 1 long. ")
CASES = (
    "Every candidate is measured, and the best is taken unless one has f*; so one good candidate is enough. Caps: one "
    "triangle an edge (`repaired.caps-whole`). No vertex on e', r = u - t >= 0 up to reflection: r >= f*, or d <= "
    "0.0535 and X <= 2: the diagonal BD, `split` and `one-slanted` or `one-near`. Else d <= 0.0535: z half way at a "
    "right angle, `one-far`, where D is not behind A; else z straight down: `one-above`, `one-right` or `one-left` at "
    "either end; `one-below`. With vertices on e': all are within h of A, the split at C: `fan`, `split`; or of B; "
    "else nested_below exists, as the fans do not meet. Leaders E, F at e and e + D from A, in units of h: e^2 <= D^2 "
    "+ 1/2, as the first is at most half as far out as z (`ratio-first`), one below a leader at 1 or less is a gap "
    "nearer (`ratio-near`), and a leader at y e, y > 1/2, is one only as it is nearer than h/5 to A-F (`ratio-sum`, "
    "`ratio-next`, `ratio-kept`). tests/proofs/test_tube_cases.py finds each face among: fan, tooth, between, end, "
    "long, top, or mirrored, with the hypotheses true, for all groupings of few apexes and at random. T-vertices of "
    "long faces are members, a gap before their leader. All is symmetric in A and B.")
CITED = ("separation.edge-sine-inside", "separation.edge-sine-beyond", "separation.longer", "separation.back",
         "separation.apart", "offset.thickness-upper", "offset.thickness-side", "offset.reach-upper",
         "offset.reach-side", "gaps.reach", "gaps.reach-upper", "gaps.edge-side", "gaps.edge-upper",
         "levels.cap-chord", "levels.cap-foot")
GROUP = "slanted"
NAMES = (*(statement.id for statement in STATEMENTS), *CITED)
THEOREMS = [
    Theorem("repaired.tube-feature", "claim", "every face of the Tube keeps g/5", NAMES, PLACES + CASES,
            "a strip of height g with leaders g/5 under its T-side"),
    Theorem("repaired.tube-feature-45", "claim", "every face of the Tube keeps 0.0223, which is above mfs/45", NAMES,
            "g/5 = 0.0464 is more. " + PLACES + CASES, "g/5 is proved"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
