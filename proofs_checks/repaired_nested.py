"""Prove that the triangles of Lemma 3* over a parallel clean side keep 0.0222 (N1-N6 at the weak target, D = 45).

Given   lengths divided by the height h of the anchors A = (0,1) and B = (D,1), D >= 4, over the T-side y = 0, which is
        g or more: t = 0.0222/h is at most T0 = 0.0957. Gaps are W >= k t, k = 6.03, because they are 0.134 or more.
        Lowest apexes stand at height 1/5 (beta), fans reach 2 (xi), mode AB. Left of z an apex is min(W/2, 1) from the
        right end of its gap; neighbouring apexes are k t or more apart. E = (e, 1/5) leads a group, e >= 1; its members
        are on A-E beyond e/2; the next leader beyond it is at f >= 2 e.
Claim   N1  a tooth over a gap; N2 the triangle of two neighbouring apexes and the T-vertex between; N3 (A, E, a), a on
        A-F beyond f/2; N3m its members against A-a, N3e against E-a; N4 (A, z, B) and its members; N5 (A, last vertex
        of the fan, first apex); N6 the fan: all heights, and all distances of members, are t or more.
Method  one problem a height or distance; `min(W/2, 1)` by cases; combinations.
Tight   N3m holds up to 1/sqrt(29) = 0.1857 and not beyond: e = 1, f = 2.
By hand that each face sees at most one gap, two neighbouring apexes or two consecutive leaders; mirror images.
"""

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
    keeps_distance,
    main,
    more,
    spot,
    square,
    states,
)

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables

T0, k, beta = mpq(957, 10000), mpq(603, 100), mpq(1, 5)
t, W, x, y, p, q, v, e, f, D, u, a, m = variables("t W x y p q v e f D u a m")
PLAIN = Hint(degrees=(4, 5, 6))
small = (more(t), at_least(T0, t))
A = spot(0, 1)


def heights(id_: str, says: str, hypotheses: tuple[Constraint, ...], corners: tuple[Spot, ...], hint: Hint = PLAIN
            ) -> list[Statement]:
    """Return that the heights of a counter-clockwise triangle are t or more."""
    area = cross(corners[1].minus(corners[0]), corners[2].minus(corners[0]))
    found = [states(f"{id_}.area", f"{says}: counter-clockwise", hypotheses, more(area), hint)]
    for corner in range(3):
        side = corners[(corner + 2) % 3].minus(corners[(corner + 1) % 3])
        found.append(bounded(
            f"{id_}.height-{corner + 1}", f"{says}: the height from corner {corner + 1}", hypotheses,
            lambda factor, side=side: at_least(area * area, square(factor) * t * t * dot(side, side)),
            hint))
    return found


# N1: by the width of the gap. Apex (x, y).
gap = (*small, at_least(W, k * t), at_least(y, beta))
N1 = heights("nested.n1-narrow", "tooth over W <= 2, apex over the middle", (*gap, at_least(2, W)),
             (spot(0, 0), spot(W, 0), spot(W / 2, y)))
N1 += heights("nested.n1-wide", "tooth over W >= 2, apex 1 or more from both ends",
              (*gap, at_least(W, 2), at_least(x, 1), at_least(W - 1, x)), (spot(0, 0), spot(W, 0), spot(x, y)))
# N2: apexes (-p, y) and (q, v) beside the T-vertex (0, 0).
N2 = heights("nested.n2", "T-vertex and its two apexes, heights 0.2 to 0.6",
             (*small, at_least(2 * p, k * t), at_least(2 * q, k * t), at_least(y, beta), at_least(mpq(3, 5), y),
              at_least(v, beta), at_least(mpq(3, 5), v)), (spot(-p, y), spot(0, 0), spot(q, v)))
# N3: a = A + x (f, -4/5) with x the fraction of A-F, 1/2 <= x <= 1.
leaders = (*small, at_least(e, 1), at_least(f, 2 * e))
half = (at_least(2 * x, 1), at_least(1, x))
E, on_AF = spot(e, beta), spot(x * f, 1 - mpq(4, 5) * x)
N3 = heights("nested.n3", "(A, E, a), a on A-F beyond f/2", (*leaders, *half), (A, E, on_AF))
# A member at the fraction y of A-E, coordinates as they are.
member = spot(y * e, 1 - mpq(4, 5) * y)
of_group = (at_least(2 * y, 1), at_least(1, y))
line = spot(f, -mpq(4, 5))
N3M = [bounded("nested.n3m", "a member keeps 1/sqrt(29) from the line A-F", (*leaders, *of_group),
               lambda factor: at_least(cross(line, member.minus(A))**2,
                                       square(factor) * dot(line, line) / 29), PLAIN)]
N3E = keeps_distance("nested.n3e", "a member, k t or more before E, against E-a",
                     (*leaders, *half, *of_group, at_least(e - y * e, k * t)), member, E, on_AF, t * t, PLAIN)
# N4: z = (e, 1/5) with 1 <= e <= D - 1.
top = (*small, at_least(e, 1), at_least(D - 1, e), at_least(D, 4))
N4 = heights("nested.n4", "(A, z, B)", top, (A, E, spot(D, 1)))
N4 += [bounded("nested.n4-members-ab", "a member against A-B", (*top, *of_group),
               lambda factor: at_least(mpq(4, 5) * y, mpq(factor) * t))]
N4 += keeps_distance("nested.n4-members-zb", "a member, k t or more before z, against z-B",
                     (*top, *of_group, at_least(e - y * e, k * t)), member, E, spot(D, 1), t * t, PLAIN)
# N5: the last fan vertex (u, 0), the first apex (a, 1 - m a) on A-E, m = 4/(5 e), e/2 <= a <= e.
first = (*small, more(m), at_least(m * a, mpq(2, 5)), at_least(mpq(4, 5), m * a))
apart = at_least(2 * (a - u), k * t)


def fan_end(id_: str, says: str, *given: Constraint) -> list[Statement]:
    """Return the heights of (A, u, a)."""
    return heights(id_, says, (*first, *given), (A, spot(u, 0), spot(a, 1 - m * a)),
                   Hint(degrees=(4, 5, 6), squares=(u - a, m * a - 1, a - 1)))


N5 = [
    states("nested.n5-place-narrow", "0 <= u <= 2 < u + W, W <= 2: a = u + W/2 >= 1 + u/2",
           (at_least(u), at_least(2, u), at_least(u + W, 2), at_least(2, W)), at_least(u + W / 2, 1 + u / 2)),
    states("nested.n5-place-wide", "0 <= u, W >= 2: a = u + W - 1 >= 1 + u/2", (at_least(u), at_least(W, 2)),
           at_least(u + W - 1, 1 + u / 2)),
    states("nested.n5-place-behind", "u < 0, u + W >= 2: a = u + W - 1 >= 1", (more(-u), at_least(u + W, 2)),
           at_least(u + W - 1, 1)),
]
N5 += fan_end("nested.n5", "fan to 0 <= u <= 2", at_least(u), at_least(2, u), at_least(a, 1 + u / 2), apart)
N5 += fan_end("nested.n5-behind", "u < 0", more(-u), at_least(a, 1))
N5 += fan_end("nested.n5-outwards", "leg outwards, u > 2", more(u, 2), apart)
N6 = heights("nested.n6", "fan: (A, u, u + W), both within 2",
             (*small, at_least(W, k * t), at_least(u, -2), at_least(2, u + W)), (A, spot(u, 0), spot(u + W, 0)))
STATEMENTS = [*N1, *N2, *N3, *N3M, *N3E, *N4, *N5, *N6]

GROUP = "nested"
THEOREMS = [Theorem(
    "repaired.tube-feature", "part", "Lemma 3* over a parallel clean side, AB >= 4 h, keeps 0.0222",
    tuple(s.id for s in STATEMENTS),
    "Only parallel clean sides, mode AB, beta = 1/5, xi = 2. Slanted sides, short sides, single gaps are not covered.",
    "N3m: 1/sqrt(29) = 0.1857, attained at e = 1, f = 2")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
