"""Prove I4 of the repaired construction: a T-vertex v keeps 0.15 from its neighbour c in Q on a horizontal side when a
chord joins them, and 0.0688 when an edge of Q does.

Given   mfs 1 (m <= mfs). K1, K2, rho as in `repaired_separation`; b, a, g of K1; 0.4247 the reach of K1. A vertex of Q
        is p + k (a cap, or a corner whose edges share the extreme k), or the crossing of two offset edges (convex).
Claim   edge: a level e' has |dx| >= 0.0688. Its ends were w + k and w1 + k1, w and w1 on the next edges of P, which are
        1 apart, and |dy| < g, as rounding to levels took both ends to one. The vector k - k1 is in 2 K1.
        cap-end: if an end is p + k then |dx| >= 0.15: p is 1 from the next edge, e' has the direction of e, k is
        extreme.
        not-flat: an e' that leaves p + k downwards to the side of p cannot become level: then no p + (+-b, y) is a
        T-vertex with a chord on the side away from p.
        chord: from p + k, or from w + (a, -3 g/2), a chord reaches the next vertex after 0.15 at least.
        longer: a level e' is 0.15 long unless k - k1 is (2b, g) or a reflection, and the other end higher accordingly.
        foot: neighbours on an edge of Q are 0.134 apart.
Tight   0.0702 in a parallelogram whose three upper corners snap to one level; 0.15 was false, as of the rhombus (0, 0),
        (1, 2), (0, 4), (-1, 2).
By hand the list of cases (in `CASES`).
"""

from gmpy2 import mpq
from kit import Hint, Statement, Theorem, at_least, bounded, main, more, square, states

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import EDGE_GAP, FLAT, GAP, LEVEL, LEVEL_EDGE, SEPARATION, THICKNESS_MAX, WIDE

x, y = variables("x y")
REACH = mpq(4247, 10000)
NEAR = (1 - REACH)**2
LEVELLED = (at_least(y, -LEVEL), at_least(LEVEL, y))
HALF = LEVEL / 2


def edge(name: str, kx: mpq, ky: mpq) -> Statement:
    """Return that a level edge is 0.0688 long where k - k1 is that vertex of 2 K1."""
    return bounded(f"gaps.edge-{name}", f"the ends of a level e', where k - k1 is the {name} vertex of 2 K1",
                   (at_least(x), *LEVELLED, at_least((kx + x)**2 + (ky + y)**2, 1)),
                   lambda f: at_least(x, LEVEL_EDGE * mpq(f)), Hint(squares=(x - mpq(7, 100), x, y)))


# k = (b, g/2) is extreme for n = (-dy, dx) or its opposite: dx and dy are of opposite signs, and steep; k = (a, 3g/2)
# alike, and not steep.
SIDE = ("side", WIDE, HALF, lambda x, y: at_least(y * (WIDE - FLAT), LEVEL * x))
TOP = ("top", FLAT, 3 * HALF, lambda x, y: at_least(LEVEL * x, y * (WIDE - FLAT)))


def cap_ends() -> list[Statement]:
    """Return that a level edge from a cap is 0.15 long; (x, y) are |dx| and |dy| here."""
    found = []
    for name, kx, ky, slope in (SIDE, TOP):
        for way, sign in (("outwards", 1), ("inwards", -1)):
            found.append(bounded(
                f"gaps.cap-end-{name}-{way}", f"a level e' that leaves p + k {way}, k the {name} vertex",
                (at_least(x), at_least(y), at_least(LEVEL, y), slope(x, y),
                 at_least((kx + sign * x)**2 + (ky - sign * y)**2, NEAR)),
                lambda f: at_least(x, GAP * mpq(f)), Hint(squares=(x - mpq(15, 100), x, y))))
    return found


def chord(name: str, kx: mpq, drop: mpq) -> Statement:
    """Return how far a chord from a vertex kx beside p reaches, at heights up to `drop` from p."""
    return bounded(f"gaps.chord-{name}", f"c is 1 - rho from p, at most {drop} above or below, v is {kx} beside p",
                   (at_least(x), at_least(y), at_least(drop, y), at_least(x * x + y * y, (1 - THICKNESS_MAX)**2)),
                   lambda f: at_least(x - kx, GAP * mpq(f)), Hint(squares=(x - mpq(1, 4), x, y)))


def longer(name: str, kx: mpq, ky: mpq, most: mpq) -> Statement:
    """Return that a level edge is 0.15 long where k - k1 is that difference of vertices, and dy at most `most`."""
    return bounded(f"gaps.longer-{name}", f"the ends of a level e', with k - k1 = ({kx}, {ky}), dy up to {most}",
                   (at_least(x), at_least(y, -LEVEL), at_least(most, y), at_least((kx + x)**2 + (ky + y)**2, 1)),
                   lambda f: at_least(x, GAP * mpq(f)), Hint(squares=(x - mpq(15, 100), x, y)))


FEET = [
    longer("level", 2 * WIDE, mpq(0), LEVEL), longer("slanted", WIDE + FLAT, 2 * LEVEL, LEVEL),
    longer("upper", 2 * FLAT, 3 * LEVEL, LEVEL), longer("falling", 2 * WIDE, LEVEL, mpq(0)),
    states("gaps.longer-back", "dx is not of the other sign", (
        at_least(x), at_least(GAP, x), *LEVELLED, at_least((2 * WIDE - x)**2 + (LEVEL + y)**2, 1)), None,
           Hint(squares=(x, y))),
    bounded("gaps.foot-near", "v, x beside the near corner of a leg of slope y < 1/2, is 0.0599 from the leg", (
        at_least(x), at_least(y), at_least(mpq(1, 2), y), at_least((x * y)**2, SEPARATION**2 * (1 + y * y))),
            lambda f: at_least(x * x * (1 + y * y), square(f) * EDGE_GAP**2),
            Hint(degrees=(2, 3, 4, 5, 6), squares=(x, y))),
    bounded("gaps.foot-far", "a foot is 2 H or more beside the far corner", (at_least(x, 2 * LEVEL),),
            lambda f: at_least(x, EDGE_GAP * mpq(f))),
    bounded("gaps.foot-pair", "feet that are x >= 0.15 apart sideways", (at_least(x, GAP),),
            lambda f: at_least(x * x + y * y, square(f) * EDGE_GAP**2), Hint(degrees=(2,), squares=(x, y))),
    bounded("gaps.levels", "vertices on two levels", (at_least(x, LEVEL),),
            lambda f: at_least(x * x + y * y, square(f) * EDGE_GAP**2), Hint(degrees=(2,), squares=(x, y))),
]
STATEMENTS = [
    bounded("gaps.reach", "K1 reaches 0.4247 at most", (at_least(x), at_least(WIDE**2 + HALF**2, x * x)),
            lambda f: at_least(REACH / mpq(f), x)),
    states("gaps.reach-upper", "its upper vertices reach less far", (
        at_least(x), at_least(FLAT**2 + (3 * HALF)**2, x * x)), at_least(WIDE**2 + HALF**2, x * x)),
    edge("side", 2 * WIDE, LEVEL), edge("upper", 2 * FLAT, 3 * LEVEL), *cap_ends(),
    states("gaps.not-flat", "an e' from p + k downwards to the side of p does not become level",
           (at_least(x), at_least(y), more(LEVEL, y), SIDE[3](x, y),
            at_least((WIDE - x)**2 + (HALF + y)**2, NEAR)), None, Hint(squares=(x, y))),
    chord("flat", FLAT, 2 * LEVEL), chord("behind", -WIDE, LEVEL), *FEET,
]
CASES = (
    "v sees below, say: its edges in Q rise or are level. "
    "v, c joined by an edge: two vertices of a cap are 2a or more apart on a level; else it is an e', and the next "
    "edges e0, e1 are disjoint, or an end is a slit end (`cap-end`), or the three are a triangle. Around a triangle "
    "from outside the ends are caps (`cap-end`); inside, with inradius 1, e' is over 1 long before snapping. "
    "v, c joined by a chord, v = p + k. c of the same cap: 2a or 2b. c at another corner of p: g, by the lines of the "
    "edges. Else c is in p' + K2 or f + K2, f an edge at p' without p. "
    "k = (+-a, y): `chord-flat`. k = (b, -g/2): one neighbour in the cap is lower; so the outgoing e' descends to the "
    "left and was made level: `not-flat`. k = (b, g/2): the outgoing e' descends to the right and was made level, so "
    "the chord is on the left: `chord-behind`. The rest is by reflection. "
    "v a crossing: by motion Q stays simple (I2), so an angle below 180 becomes 180 or more only if an edge becomes "
    "level, say the outgoing one, to the left, and the incoming e0' descends less steeply: k0 = (a, -3g/2), as "
    "the two share no k. v is w + k0 moved, w on e0, and c is in p' + K2 or f + K2, 1 from e0: `chord-flat`. "
    "Otherwise c is at the far end of e0, where the cap is not lower than the end of e0', which is higher than v, or "
    "at another corner there, beyond an edge, if within 0.15; or e0 is a side of a triangle, where c is over 1 from v.")
FOOT_CASES = (
    "A chord end is on a level strictly between those of the ends of its edge. Feet on one leg come from one side of "
    "one trapezoid, from neighbours there that are 0.15 apart (`repaired.chord-gap`) unless they end a level e' with "
    "two crossings. Then, by `longer`, up to reflection v is the higher end before snapping, k at v is (-b, -g/2), at "
    "c it is (b, g/2), and the next edge at c descends away from c to the side of v, or straight down. It was not made "
    "level, as it would lie on e'. So c is the corner of the trapezoid whose leg leans to v's side: no foot of c is on "
    "that leg, and none on the other, which ends beside c on the same side. A wedge is cut where the leg is flatter "
    "than 1/2, and a foot is 2 H before the far corner.")
GROUP = "gaps"
NAMES = tuple(statement.id for statement in STATEMENTS)
THEOREMS = [
    Theorem("repaired.chord-gap", "claim", "along a chord a T-vertex keeps 0.15 from vertices of Q beside it",
            (*NAMES, "offset.separation", "offset.reaches"), CASES, "0.15 is the width of a flat cap"),
    Theorem("repaired.level-edge", "claim", "a level edge of Q at a T-vertex is 0.0688 long or longer",
            (*NAMES, "offset.separation", "offset.reaches"), CASES, "0.0702 in a parallelogram"),
    Theorem("repaired.edge-gap", "claim", "neighbours on an edge of Q keep 0.134", NAMES, FOOT_CASES + " " + CASES,
            "0.1497 from the near corner is proved"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
