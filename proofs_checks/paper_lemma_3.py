"""Prove Lemma 3's fan, constant and count, and Theorem 2's layers: `lemma-3.fan-distance`, `lemma-3.degradation`,
`lemma-3.vertex-count`, `theorem-2.layered-rectangle`.

Given   places as in `lemma_3.py` and `layered_rectangle.py`: x in units of w, a whole number for positions and nodes;
        y from 0 to 1 in units of h. A = (0,1). Nodes E_i = (x_i, 1/3): x_1 = 1, x_i+1 = 2 x_i but for the last, which
        has 2 x_i <= x_i+1 < 4 x_i. Between x_i and X = x_i+1 the edge e_i+1 has heights from 1/3 to 5/6 and a slope -s,
        0 <= s <= 1/3. Layers: J rows, d = 1/J apart, the lowest on the side, the highest d below the upper side.
Claim   fan: f1 = w h/sqrt(h^2 + 36 w^2). constant: with w = h = 1, faces keep 1/sqrt(37), with either kind of teeth.
        count: 3 c. layers: with w = h = 1, d/sqrt(2).
Method  `stretch`: the figure for w, h >= m is that for w = h = 1, stretched by m or more in both directions, so each of
        its distances, also of a point from a segment, is at least m times as long: w = h = 1 suffices.
        A face is judged by its heights, doubled area over side, and its T-vertices by distances from the other sides.
        `tooth`: u below e_i+1 by v >= 1/3 and two points of that edge, c >= 1/2 apart, on either side of u: the height
        onto the side from u to the one, a away. So are all faces below e_i+1, with u a position, or with E_i and top_i
        for a vertical side, or with a base on the side and its apex at a height v; `below` is the height onto e_i+1.
        `gap-chain`: faces (u_j, E_i, E_i+1) of a gap with several nodes. `slanting`: heights onto A E_i and from C.
        `nearest-end` of the group refinement: E_L is the nearest point of E_L C to vertices on A E_L.
        Layers: the faces at the ends of a strip, between two of its vertices, right triangles below a vertex, and the
        uppermost face.
Tight   f1: x_i = 2, x_i+1 = 4, every h and w. 1/sqrt(37): there, and in a gap from 0 with nodes 1 and 2. Layers: an
        even number of vertices, the last one w from the end: the face there has the height d/sqrt(2).
By hand that the faces of the two figures are those named here, which the programs' texts show; that vertices on e_i are
        at abscissae from x_i-1 on, 1/2 apart and 1/2 before x_i: tops at x_i-1, teeth over the middles of gaps.
"""

from gmpy2 import mpq
from kit import PLAIN, Hint, Statement, Theorem, at_least, bounded, main, more, square, states

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables

w, h, m, x, y, xi, xj, a, b, c, d, v, s, g, p, t, k = variables("w h m x y xi xj a b c d v s g p t k")
CONSTANT = mpq(1, 37)
LOW, HIGH = mpq(1, 3), mpq(5, 6)


def height(id_: str, says: str, hypotheses: tuple[Constraint, ...], area: Polynomial, side_squared: Polynomial,
           bound_squared: Polynomial | mpq = CONSTANT, hint: Hint = PLAIN, sharp: dict[str, str] | None = None
           ) -> Statement:
    """Return that doubled area over a side is at least the bound."""
    return bounded(f"lemma-3.{id_}", says, hypotheses,
                   lambda f: at_least(area * area, bound_squared * square(f) * side_squared), hint, sharp)


POSITIVE = (more(w), more(h))
F1 = w * w * h * h
FAN = [
    # p = (x, 1 - 2 x/(3 xi)) on e_i; from A the direction of e_i+1 is (w xj, -2 h/3). Both sides times 9 xi^2.
    bounded("lemma-3.fan-first", "E_1 = (1, 1/3) is f1 from e_2, x_2 >= 2",
            (*POSITIVE, at_least(xj, 2)),
            lambda f: at_least(4 * (xj - 1)**2 * (h * h + 36 * w * w), square(f) * (9 * w * w * xj * xj + 4 * h * h)),
            Hint(degrees=(4, 5, 6))),
    bounded("lemma-3.fan-next", "a vertex on e_i at x >= x_i/2 is f1 from e_i+1, x_i >= 2",
            (*POSITIVE, at_least(xi, 2), at_least(2 * x, xi), at_least(xj, 2 * xi)),
            lambda f: at_least(4 * x * x * (xj - xi)**2 * (h * h + 36 * w * w),
                               square(f) * xi * xi * (9 * w * w * xj * xj + 4 * h * h)),
            Hint(degrees=(6, 7)), {"w": "1", "h": "1", "xi": "2", "x": "1", "xj": "4"}),
    # (0,0) against A E_1: doubled area w h, side^2 w^2 + 4 h^2/9.
    bounded("lemma-3.fan-corner", "(0,0) is f1 from e_1", POSITIVE,
            lambda f: at_least(9 * (h * h + 36 * w * w), square(f) * (9 * w * w + 4 * h * h))),
    # 2 x h/(3 L), and f1^2 <= h^2/36 because h^2 + 36 w^2 >= 36 w^2.
    bounded("lemma-3.fan-last", "a vertex on the last e at x >= L/4 is f1 from the upper side",
            (*POSITIVE, at_least(xi, 1), at_least(4 * x, xi)),
            lambda f: at_least(4 * x * x * (h * h + 36 * w * w), square(f) * 9 * w * w * xi * xi),
            Hint(degrees=(4, 5, 6))),
]
STRETCH = [bounded("lemma-3.stretch", "stretching by w, h >= m makes lengths m times as long or longer",
                   (more(m), at_least(w, m), at_least(h, m)),
                   lambda f: at_least((w * x)**2 + (h * y)**2, square(f) * m * m * (x * x + y * y)),
                   Hint(squares=(x, y), degrees=(4,)))]
FACES = [
    states("lemma-3.heights-from", "2 x_i <= x_i+1: top_i is 1/3 or more above E_i", (more(xi), at_least(xj, 2 * xi)),
           at_least(2 * (xj - xi), xj)),
    states("lemma-3.heights-to", "x_i+1 <= 4 x_i: e_i+1 is at most 5/6 high from x_i on",
           (more(xi), at_least(4 * xi, xj)), at_least(mpq(5, 2) * xj, 3 * xj - 2 * xi)),
    height("below", "a point below e_i+1 by v >= 1/3", (at_least(v, LOW), at_least(s), at_least(LOW, s)), v,
           1 + s * s),
    height("tooth", "a point below e_i+1 by v, two points of it c apart, one of them a away and y above",
           (at_least(v, LOW), at_least(y), at_least(HIGH, y), at_least(a), at_least(c, a), at_least(2 * c, 1)),
           v * c, a * a + y * y, hint=Hint(degrees=(4, 5)),
           sharp={"v": "1/3", "y": "5/6", "a": "1/2", "c": "1/2"}),
    height("right", "a right triangle over a whole number a >= 1 and v >= 1/3", (at_least(a, 1), at_least(v, LOW)),
           a * v, a * a + v * v, sharp={"a": "1", "v": "1/3"}),
    height("gap-chain-far", "(u_j, E_i, E_i+1) onto u_j E_i+1: a = x_i - u_j, d = x_i+1 - x_i >= a",
           (at_least(a, 1), at_least(d, a)), d / 3, (a + d)**2 + mpq(1, 9), sharp={"a": "1", "d": "1"}),
    height("gap-chain-near", "onto u_j E_i", (at_least(a, 1), at_least(d, a)), d / 3, a * a + mpq(1, 9)),
    height("slanting", "onto A E_i from 1/3 above or below E_i, and onto E_L C from (c,0), c - L = x",
           (at_least(x, 1),), x / 3, x * x + mpq(4, 9), sharp={"x": "1"}),
    bounded("lemma-3.sixth", "vertices on the last e are 1/6 or more below the upper side: 4 x >= L",
            (at_least(6 * v, 1),), lambda f: at_least(v * v, CONSTANT * square(f)), sharp={"v": "1/6"}),
    states("lemma-3.last-obtuse", "the angle A E_L C is not acute: (-L,2/3).(c - L,2/3) <= 0",
           (at_least(xi, 1), at_least(d, 1)), at_least(xi * d, mpq(4, 9))),
]
COUNT = [
    states("lemma-3.count-octave", "x_i >= i goes on: x_i+1 >= 2 x_i >= i + 1",
           (at_least(x, 1), at_least(x, k), at_least(y, 2 * x)), at_least(y, k + 1)),
    bounded("lemma-3.count-all", "k nodes, k - 1 tops, t teeth: t <= c - 1, k <= L <= c - 1",
            (at_least(k, 1), at_least(t), at_least(c - 1, t), at_least(c - 1, k)),
            lambda f: at_least(3 * c / mpq(f), 2 * k - 1 + t)),
]
HALF = d * d / 2
ROW = (more(d), at_least(1, d))
STRIP = (more(d), at_least(y, 2 * d), at_least(1, y), at_least(p, 1))
AREA = y * g + d * p
LAYERS = [
    height("layers-right", "a right triangle over g >= 1, v high, d <= v <= 1", (*ROW, at_least(v, d), at_least(1, v),
           at_least(g, 1)), g * v, g * g + v * v, HALF, Hint(degrees=(4, 5)), {"d": "1", "v": "1", "g": "1"}),
    height("layers-top", "the uppermost face, from its vertex to an upper corner x away", (*ROW, at_least(x, 1),
           at_least(c, x + 1)), c * d, x * x + d * d, HALF, Hint(degrees=(4, 5, 6))),
    height("layers-between", "(u, v, v') with v' v on the row above, c apart, v being b away",
           (*ROW, at_least(b, 1), at_least(c, b + 1)), c * d, b * b + d * d, HALF, Hint(degrees=(4, 5, 6))),
    height("layers-end-short", "the face at the end of a strip, y below A: its side between the rows",
           (*STRIP, at_least(g, 1)), AREA, g * g + d * d, HALF, Hint(degrees=(4, 5, 6), cells=2000)),
    height("layers-end-low", "its side to the lower row", (*STRIP, at_least(g, 1)), AREA, p * p + y * y, HALF,
           Hint(degrees=(4, 5, 6), cells=2000)),
    height("layers-end-high", "its side to the upper row", (*STRIP, at_least(g, 1)), AREA,
           (p + g)**2 + (y - d)**2, HALF, Hint(degrees=(4, 5, 6), cells=2000)),
    height("layers-upright-short", "where both rows end at one abscissa: the vertical side", STRIP, d * p, d * d, HALF,
           Hint(degrees=(4, 5, 6))),
    height("layers-upright-low", "its side to the lower row", STRIP, d * p, p * p + y * y, HALF,
           Hint(degrees=(4, 5, 6)), {"d": "1/2", "y": "1", "p": "1"}),
    height("layers-upright-high", "its side to the upper row", STRIP, d * p, p * p + (y - d)**2, HALF,
           Hint(degrees=(4, 5, 6))),
]
STATEMENTS = [*FAN, *STRETCH, *FACES, *COUNT, *LAYERS]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


GROUP = "paper-lemma-3"
THEOREMS = [
    Theorem("lemma-3.fan-distance", "claim", "vertices on an anchored edge are f1 or more from the next one",
            names(FAN), "Faces at A: (A, (0,0), E_1), those between e_i and e_i+1, and the one below the upper side. "
            "Vertices on e_i, i > 1, begin at x_i-1, which is x_i/2, or above x_i/4 on the last edge, which has the "
            "upper side as its next one. Distances from lines bound those from segments.",
            "attained for every w and h by x_i = 2, x_i+1 = 4, the vertex at x = 1"),
    Theorem("lemma-3.degradation", "claim", "all faces keep min(h, w)/sqrt(37), with both kinds of teeth",
            (*names(FAN, STRETCH, FACES), "refinement.nearest-end"),
            "w = h = 1 by `stretch`; the faces of the figure one by one, as in the script. Vertices on one side are "
            "1/3 or 1/2 apart. In right-angled and flat faces heights onto horizontal and vertical sides are 1/3 or "
            "more. The vertices on the last e are nearest to E_L among the points of E_L C, 1/2 or more away.",
            "attained for h = w: f1 with x_i = 2, x_i+1 = 4, and a gap from 0 beyond 2 with the nodes 1 and 2"),
    Theorem("lemma-3.vertex-count", "claim", "at most 3 c new vertices", names(COUNT),
            "By induction x_k >= k, so there are at most L nodes, L the last inner position, L <= c - 1. Each node but "
            "the first has one top; a tooth has its own gap, and the last gap has none: at most c - 1.",
            "at most 3 c - 4, by the same sum"),
    Theorem("theorem-2.layered-rectangle", "claim", "all faces keep min(h, w)/(sqrt(2) J), J = 1 + floor(log2 n)",
            names(STRETCH, LAYERS),
            "w = h = 1 by `stretch`; inner vertices of the side are 1 or more apart and from its ends, and so are "
            "those of each row. The faces are two right triangles at the ends of the side, the uppermost one, and in "
            "each strip those at its ends, right triangles, and faces between two of its upper vertices. The highest "
            "row is d below the upper side: so y >= 2 d for the lower row of a strip.",
            "attained: an even number of vertices, the last one w from the end"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
