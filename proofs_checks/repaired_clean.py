"""Prove that trapezoids without T-vertices keep f* = g/5 in the repaired construction, at the full value (steps A0-A3).

Given   a trapezoid BL = (0,0), BR = (b,0), TR = (x,H), TL = (x - a,H); H >= g; vertices of Q keep F = 599/10000 from
        edges of Q without them (I2, checked on every run); a corner that is no vertex is inside an edge that goes on
        for g or more beyond it (I5', checked on every run). A vertex of Q at a corner is good when it is at distance
        Fp = g f*/(g - f*) = 0.058 or more from the line of the opposite leg.
Claim   A0  of three heights of a triangle with two at least P and Q, the third is at least P Q/(P + Q).
        A1  BL, a vertex, is good (even F) if the right leg leans over it, or BR is no vertex; else b >= F.
        A2  good BL and TR: the diagonal BL-TR leaves f*; good BL and TL with a >= b: so it does.
        A3  no good corner below: both corners are vertices, both legs lean outwards, and the centre (b/2, H/2), joined
            to the four corners, leaves f*.
Method  A0 is the triangle inequality for the sides S/height. A2 is A0 with P = g, Q = Fp, where that is enough; all
        else are combinations with nonnegative coefficients.
Tight   A2: with F in place of Fp the diagonal leaves g F/(g + F) = 0.0476, not 0.0477.
By hand the split: if both sides have a good vertex, A2 (mirrored or upside down); if one has none, A3 at that side. An
        apex face (a = 0) with a good BL is one triangle, A0.
"""

from gmpy2 import mpq
from kit import Hint, Spot, Statement, Theorem, at_least, bounded, cross, dot, main, more, spot, square, states

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables
from exactmesh.steps.constants import FEATURE, LEVEL, SEPARATION

g, F, f_star = LEVEL, SEPARATION, FEATURE
GOOD = g * f_star / (g - f_star)
a, b, c, x, r, H, S, P, Q = variables("a b c x r H S P Q")


def heights(id_: str, says: str, hypotheses: tuple[Constraint, ...], corners: tuple[Spot, ...], target: mpq,
            hint: Hint) -> list[Statement]:
    """Return that all three heights of a counter-clockwise triangle are at least `target`."""
    found = []
    area = cross(corners[1].minus(corners[0]), corners[2].minus(corners[0]))
    for k in range(3):
        side = corners[(k + 2) % 3].minus(corners[(k + 1) % 3])
        found.append(bounded(f"{id_}.height-{k + 1}", f"{says}: the height from corner {k + 1}", hypotheses,
                             lambda f, side=side: at_least(area * area, square(f) * target**2 * dot(side, side)), hint))
    return [states(f"{id_}.area", f"{says}: counter-clockwise", hypotheses, more(area), hint), *found]


def squared(p: Polynomial, q: Polynomial) -> Polynomial:
    """Return the squared length of a vector."""
    return p * p + q * q


A0 = [
    states("clean.a0", "S = twice the area, sides a, b, c: heights S/a >= P and S/b >= Q make S/c >= P Q/(P + Q)",
           (more(a), more(b), more(c), more(P), more(Q), at_least(S, a * P), at_least(S, b * Q), at_least(a + b, c)),
           at_least(S * (P + Q), c * P * Q)),
    states("clean.a0-values", "P >= g and Q >= Fp make P Q/(P + Q) >= f*", (at_least(P, g), at_least(Q, GOOD)),
           at_least(P * Q, f_star * (P + Q))),
]
leg = squared(r, H)
A1 = [
    states("clean.a1-over", "r <= 0 and the foot of BL beyond the right leg: at distance F or more from its line",
           (at_least(b), at_least(H, g), at_least(0, r), more(-b * r, leg)), at_least(b * b * H * H, F * F * leg)),
    states("clean.a1-below", "r > 0 and the foot of BL farther than g below BR: F or more from the line",
           (at_least(b), at_least(H, g), more(r), more(b * r * H, g * leg)), at_least(b * b * H * H, F * F * leg)),
    states("clean.a1-good", "F is above Fp", (at_least(P, F),), at_least(P, GOOD)),
]
right, left = squared(x - b, H), squared(x - a, H)
same_side = (more(a), more(b), at_least(H, g), at_least(a, b), at_least(b * b * H * H, GOOD**2 * right),
             at_least(a * a * H * H, GOOD**2 * right))
A2 = heights("clean.a2-lower", "good BL: triangle BL, BR, TR",
             (more(b), at_least(H, g), at_least(b * b * H * H, GOOD**2 * right)),
             (spot(0, 0), spot(b, 0), spot(x, H)), f_star, Hint(cases=(at_least(x),), degrees=(4, 5, 6)))
A2 += heights("clean.a2-upper", "good BL and TL, a >= b: triangle BL, TR, TL", same_side,
              (spot(0, 0), spot(x, H), spot(x - a, H)), f_star, Hint(cases=(at_least(x),), degrees=(4, 5, 6)))
# From here on r and c are how far the legs lean for a height of 1.
outward = (at_least(b, F), at_least(H, g), more(r), more(GOOD**2 * (1 + r * r), b * b))
centre = spot(b / 2, H / 2)
A3 = heights("clean.a3-below", "no good corner below: triangle BL, BR, centre", (at_least(b, F), at_least(H, g)),
             (spot(0, 0), spot(b, 0), centre), f_star, Hint())
A3 += heights("clean.a3-right", "no good corner below: triangle BR, TR, centre", outward,
              (spot(b, 0), spot(b + r * H, H), centre), f_star, Hint(degrees=(4, 5, 6, 7, 8), squares=(r, b)))
A3 += heights("clean.a3-above", "no good corner below: triangle TR, TL, centre",
              (*outward, more(c), more(GOOD**2 * (1 + c * c), b * b)),
              (spot(b + r * H, H), spot(-c * H, H), centre), f_star, Hint(degrees=(4, 5, 6)))
STATEMENTS = [*A0, *A1, *A2, *A3]

GROUP = "clean"
THEOREMS = [Theorem(
    "repaired.interior-feature", "part", "trapezoids without T-vertices keep f* = g/5", tuple(s.id for s in STATEMENTS),
    "WLOG as in the script. If both sides have a good vertex, A2; otherwise A3. I2 and I5' are asserted on every run. "
    "Faces with T-vertices are in `repaired_interior`.", "A2 with F for Fp leaves 0.0476")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
