"""Prove that pieces with T-vertices on one side keep f* = g/5 in the Interior of the repaired construction.

Given   lengths divided by the height H >= g of a piece: t = f*/H is at most 1/5. The anchors are A = (0,1), B = (D,1),
        the T-side u_0 < .. < u_m lies on y = 0. `repaired_interior` derives from the steps: u_1 >= -2, u_m-1 <= D + 2;
        gaps are w = 0.15/H wide or wider, except that at an end of the T-side u_1 may instead be at distance
        F = 0.0599/H or more from the line of A u_0 (u_m-1 from that of B u_m), and that D may be less when A is as far
        from the line of B u_m (or B from that of A u_0), or D >= F and both legs lean outwards.
Claim   with an anchor X at distance v beside an end of a base W, the height from that end's neighbour onto the side to
        X is t or more when W^2 >= t^2 (1 + v^2). All faces of splits are such; K1-K6 have the cases.
        H   a hub (D/2, 4/5) between fans, where no split at any u_j, nor corner, is good.
        J   leaders e < f < g of the last nested candidate (beta = 1/5, reach 2, members at t or more from the line of
            the leader before): g^2 + 4/25 >= 2 f g leads to f^2 + 4/25 >= 2 e f.
        N   the faces of that candidate for D >= 4, as in `repaired_nested`, but at t <= 1/5 with J for f >= 2 e.
Method  one problem a height or distance; combinations.
Tight   N1 and J are as tight as can be: a strip cannot keep more than a fifth of its height.
By hand which face is of which kind (`SPLITS`, `NESTS`).
"""

from gmpy2 import mpq
from kit import (
    Hint,
    Statement,
    Theorem,
    at_least,
    bounded,
    equal,
    main,
    more,
    spot,
    square,
    states,
)
from repaired_nested import heights

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables
from exactmesh.steps.constants import FEATURE, GAP, SEPARATION

t, W, v, p, r, s, D, c, x, y, q, e, f, h, u, a, m = variables("t W v p r s D c x y q e f h u a m")
w, F = GAP / FEATURE * t, SEPARATION / FEATURE * t
J = mpq(4, 25)
SMALL = (more(t), at_least(mpq(1, 5), t))
DEGREES = (2, 3, 4, 5, 6)


def reaches(id_: str, says: str, hypotheses: tuple[Constraint, ...], v: Polynomial) -> Statement:
    """Return that W^2 >= t^2 (1 + v^2)."""
    return bounded(f"pieces.{id_}", says, (*SMALL, *hypotheses),
                   lambda factor: at_least(W * W, square(factor) * t * t * (1 + v * v)),
                   Hint(degrees=DEGREES))


K = [
    reaches("k1", "a gap of w or more, not more than 12/5 and itself from the anchor",
            (at_least(W, w), at_least(v), at_least(mpq(12, 5) + W, v)), v),
    reaches("k2", "a gap from p on, at F or more from the line of A and p: its other end; s is the length of A p",
            (more(W), more(s), equal(s * s, 1 + p * p), at_least(s, p), at_least(W, F * s)), p + W),
    reaches("k3", "a gap at F or more from a leg that leans by 2 or more, not more than 2 and itself from the anchor",
            (more(W), at_least(W * W, 5 * F * F), at_least(w, W), at_least(v), at_least(2 + W, v)), v),
    reaches("k4", "a base at F or more from a leg that leans by r, not more than that from the anchor",
            (at_least(W * W, F * F * (1 + r * r)), at_least(v), at_least(r, v)), v),
    reaches("k5", "a gap and D at F or more from a leg that leans inwards by r: the end of the gap before A",
            (more(W), more(D), at_least(W * W, F * F * (1 + r * r)), at_least(D * D, F * F * (1 + r * r)),
             at_least(w, W), at_least(r), at_least(W, D)), r + W - D),
    reaches("k6", "a base of F or more, not more than w from the anchor",
            (at_least(W, F), at_least(v), at_least(w, v)), v),
]
# H: D too short for a split at the corners, u_0 = (-c, 0).
HUB = spot(D / 2, mpq(4, 5))
FAR = (*SMALL, at_least(D, F), at_least(w, D), at_least(c), more(t * t * (1 + (D + c) * (D + c)), D * D))
HS = heights("pieces.hub-top", "A, hub, B", (*SMALL, at_least(D, F)), (spot(0, 1), HUB, spot(D, 1)),
             Hint(degrees=DEGREES))
SIDE = heights("pieces.hub-side", "A, u_0, hub", FAR, (spot(0, 1), spot(-c, 0), HUB), Hint(degrees=DEGREES))
SIDE[3] = bounded(
    "pieces.hub-side.height-3", "A, u_0, hub: the height from the hub; twice the area is D/2 + c/5, and 1/5 >= t", FAR,
    lambda factor: at_least((D / 2 + c * t)**2, square(factor) * t * t * (1 + c * c)), Hint(degrees=DEGREES))
HS += SIDE
HS += [
    bounded("pieces.hub-gap", "a gap of w or more, the hub not more than 2 + D/2 beside its end",
            (*SMALL, at_least(W, w), at_least(w, D), at_least(v), at_least(2 + D / 2, v)),
            lambda factor: at_least(W * W * mpq(16, 25), square(factor) * t * t * (mpq(16, 25) + v * v)),
            Hint(degrees=DEGREES)),
    bounded("pieces.hub-wide", "a gap of w or more, the hub not more than itself and D/2 beside its end",
            (*SMALL, at_least(W, w), at_least(w, D), at_least(v), at_least(W + D / 2, v)),
            lambda factor: at_least(W * W * mpq(16, 25), square(factor) * t * t * (mpq(16, 25) + v * v)),
            Hint(degrees=DEGREES)),
]
# J: leaders e < f < h. With t <= 1/5, e is too near to the line of h, or not more than f/2.
JS = [
    states("pieces.j-half", "e at f/2 or less", (at_least(e, 1), more(f), at_least(f, 2 * e)),
           at_least(f * f + J, 2 * e * f)),
    states("pieces.j-near", "e nearer than 1/5 to the line of h, below that of f",
           (at_least(e, 1), more(f, e), more(h, f), at_least(h * h + J, 2 * f * h),
            more(f * f * (h * h + mpq(16, 25)), 16 * e * e * (h - f) * (h - f))), at_least(f * f + J, 2 * e * f),
           Hint(degrees=(4, 5, 6, 7, 8))),
]
NARROW = mpq(217, 100) * t
G = [
    states("pieces.narrow", "a gap that ends beyond 2, at F or more from the line of A and its beginning",
           (*SMALL, more(W), more(p + W, 2), at_least(w, W), at_least(W * W, F * F * (1 + p * p))),
           at_least(W, NARROW), Hint(degrees=DEGREES)),
]
# N1: a tooth, by the width of its gap. N2: apexes (-p, y) and (q, v) beside the T-vertex (0, 0).
BETA = mpq(1, 5)
LOW = (*SMALL, at_least(W, NARROW), at_least(y, BETA))
N = heights("pieces.n1-narrow", "tooth over W <= 2, apex over the middle", (*LOW, at_least(2, W)),
            (spot(0, 0), spot(W, 0), spot(W / 2, y)))
N += heights("pieces.n1-wide", "tooth over W >= 2, apex 1 or more from both ends",
             (*LOW, at_least(W, 2), at_least(x, 1), at_least(W - 1, x)), (spot(0, 0), spot(W, 0), spot(x, y)))
N += heights("pieces.n2", "T-vertex and its two apexes, heights 1/5 to 3/5",
             (*SMALL, at_least(2 * p, NARROW), at_least(2 * q, NARROW), at_least(y, BETA), at_least(mpq(3, 5), y),
              at_least(v, BETA), at_least(mpq(3, 5), v)), (spot(-p, y), spot(0, 0), spot(q, v)))
# N3: the leader E = (e, 1/5), the leader (f, 1/5) before it, a at the fraction x of A-f: at least half, and beyond E.
LEADERS = (*SMALL, at_least(e, 1), more(f, e), at_least(f * f + J, 2 * e * f))
HALF = (at_least(2 * x, 1), at_least(1, x), at_least(x * f - e, NARROW))
A, E, ON_AF = spot(0, 1), spot(e, BETA), spot(x * f, 1 - mpq(4, 5) * x)
N3 = heights("pieces.n3", "(A, E, a), a on A-f beyond f/2", (*LEADERS, *HALF), (A, E, ON_AF))
# The side A-a is on the line A-f.
N3[2] = bounded("pieces.n3.height-2", "(A, E, a), a on A-f beyond f/2: the height from E", LEADERS,
                lambda factor: at_least(16 * (f - e) * (f - e), square(factor) * 25 * t * t * (f * f + mpq(16, 25))),
                Hint(cases=(at_least(e, f / 2),), degrees=(4, 5, 6, 7, 8)))
N += N3
# A member of the group of E, or of z, against the side from there to a or B, none of which is before E.
N += [bounded("pieces.n3-member", "a member, W before E, and a point of E-a, x beyond E, v above the member",
              (*SMALL, at_least(W, NARROW), at_least(x)),
              lambda factor: at_least((W + x) * (W + x) + v * v, square(factor) * t * t),
              Hint(degrees=(2,), squares=(v,)))]
# N4: z = (e, 1/5), 1 <= e <= D - 1.
TOP = (*SMALL, at_least(e, 1), at_least(D - 1, e), at_least(D, 4))
N += heights("pieces.n4", "(A, z, B)", TOP, (A, E, spot(D, 1)))
N += [bounded("pieces.n4-members-ab", "a member, at the fraction y of A-z, against A-B",
              (*SMALL, at_least(2 * y, 1)), lambda factor: at_least(mpq(4, 5) * y, mpq(factor) * t))]
# N5: the last fan vertex (u, 0), the first apex (a, 1 - m a) on A-E, m = 4/(5 e), e/2 <= a <= e.
FIRST = (*SMALL, more(m), at_least(m * a, mpq(2, 5)), at_least(mpq(4, 5), m * a))
APART = at_least(2 * (a - u), NARROW)


def fan_end(id_: str, says: str, *given: Constraint) -> list[Statement]:
    """Return the heights of (A, u, a)."""
    return heights(id_, says, (*FIRST, *given), (A, spot(u, 0), spot(a, 1 - m * a)),
                   Hint(degrees=(4, 5, 6), squares=(u - a, m * a - 1, a - 1)))


N5 = fan_end("pieces.n5", "fan to 0 <= u <= 2", at_least(u), at_least(2, u), at_least(a, 1 + u / 2), APART)
N5 += fan_end("pieces.n5-behind", "u < 0", more(-u), at_least(a, 1))
N5 += fan_end("pieces.n5-outwards", "leg outwards, u > 2", more(u, 2), APART)
STATEMENTS = [*K, *HS, *JS, *G, *N, *N5]

SPLITS = (
    "A fan of A, base from u to u + W: its heights are 1, and by K with v = |u| and |u + W|; those of (A, u_i, B) are "
    "1, and by K with W = D, v = |u_i| and |D - u_i|. K1 is for gaps of w or more; K2 for those at an end that are "
    "off the leg from the same anchor, short in what follows. Gaps between T-vertices are not short. A = B: all "
    "T-vertices are within 2. w <= D <= 4: split at the u_i nearest to D/2; at u_1 if that is u_0, and u_0 < -2 or "
    "the first gap is short; alike at u_m. If u_i > D/2, then u_i-1 is as far before D/2, or i = 1 and u_0 is: so u_i "
    "is within 2 and its gap. D > 4: if u_m <= 2, the fan of A (K3 where the last gap is short); alike for B; else "
    "the nested triangles. D < w, A off the line of B u_m, r = u_m - D: if u_m-1 >= D, split there (K2, K4). "
    "Otherwise, if r >= 0 and the last gap is short, split there (K6); if r >= 0 and it is not, the fan of A, (A, "
    "u_m, B) by K2 and K4; if r < 0, the fan of A (K4, K5, K6). Alike for B. D < w, both legs outwards: if D is "
    "enough for a split at some u_i, then for the one nearest to D/2: K1, or a gap of w is enough as D is; if that is "
    "u_0 and the first gap is short, D is enough for u_1 (K6). Else the hub between fans, joined to T-vertices, and "
    "to a corner where there are none on its side: H. A gap across D/2 is w or more, else K6.")
NESTS = (
    "Nested: all apexes are 1 or more beside A and B; fans reach 2, so gaps without are w or more, or `narrow`. Left "
    "of z an apex is inset by half its gap or by 1 from the right: neighbours are as far apart as the narrowest gap. "
    "z is 1 or more beside both. Each face sees one gap (N1), two neighbouring apexes (N2), two consecutive leaders "
    "(N3, J; members keep 1/5 from the line before by the rule itself), z (N4) or the end of a fan (N5; K1 and K2 for "
    "the fan).")
GROUP = "pieces"
THEOREMS: list[Theorem] = []

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
