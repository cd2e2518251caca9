"""Prove that a proper mesh keeps the lesser of 0.0223 and 3/5 g/(R + 1), R the number of rows of layers: its
degradation is at most 22 (1 + log2 n), n the number of corners (`repaired.proper-degradation-22`).

Given   pieces of the Interior as in `repaired_interior`, of the Tube as in `repaired_tube`. Layers: A = (0,0), B =
        (D,0), the T-side above, over its lower end h >= g. Rows are parallel to A B and h/(R + 1) = k apart, the first
        h - k high. Gaps are 2 q or more along A B, q = 0.0503; the T-side has a slope of 1/2 at most. Lengths are
        divided by the lesser of k and q: then k >= 1, gaps are 2 or more.
Claim   tooth      a gap and its apex, or two neighbours in a row and the vertex over them
        between    a T-vertex and the apexes beside it
        end        A, the last vertex of the fan or the first of the T-side, the first apex
        row        A and the first vertices of two rows
        quad       two neighbours in a row and those in the next row, by the diagonal to the nearer of these
        top        A, B and the last row
        split      in the Interior, a clean side of less than w, split at any T-vertex
        bound      what follows
Method  combinations, a problem a height.
Tight   `quad` keeps 2/sqrt(10) = 0.632 of the spacing, at the least gap.
By hand `ROWS`, `CASES`, `COUNT`. That the list of faces is complete is checked by program: each leaf of
        `repaired_interior` has its place in `PROPER`, and `tests/proofs/test_layer_cases.py` finds each face of layers
        among the cases, with the hypotheses true of it.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, main, spot, square, states
from repaired_interior import LEAVES
from repaired_pieces import SMALL
from repaired_tube import ALONG, A, height, triangle, within

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import (
    FEATURE,
    GAP,
    LEVEL,
    PROPER_LOGARITHM,
    SEPARATION,
    TUBE_FEATURE,
    UNIT_SLACK,
)

t, W, b, c, d, e, h, k, l, m, p, q, r, v, x, D = variables("t W b c d e h k l m p q r v x D")  # noqa: E741
KEPT = mpq(3, 5)
SOME = Hint(degrees=(2, 3, 4))

SLOPE = within(m, -mpq(1, 2), mpq(1, 2))
TOOTH = [
    height("layers.tooth-apex", "a tooth, d deep: the height from its apex", (*SLOPE, at_least(d, 1)), d, spot(1, m),
           KEPT),
    height("layers.tooth-side", "a tooth over W, its apex p along: the height over a side", (
        *SLOPE, at_least(d, 1), at_least(W, 2), *within(p, 0, W)), W * d, spot(p, m * p - d), KEPT, SOME),
]
BESIDE = (at_least(p, 1), at_least(q, 1), at_least(d, 1))
BETWEEN = triangle("layers.between", "two apexes p and q beside a T-vertex d above them", BESIDE,
                   (spot(-p, 0), spot(q, 0), spot(0, d)), KEPT, SOME)
# The apex is r high, the vertex of the T-side d higher.
HIGH = (at_least(r, 1), at_least(d, 1), at_least(x))
END = triangle("layers.end-right", "A, the apex c beyond v, v = (x, r + d)", (*HIGH, at_least(c, 1)),
               (A, spot(x + c, r), spot(x, r + d)), KEPT, SOME)
END += triangle("layers.end-left", "A, the apex at p >= r, v = (-x, r + d)", (*HIGH, at_least(p, r)),
                (A, spot(p, r), spot(-x, r + d)), KEPT, SOME)
END += [
    states("layers.place", "an apex is h - k from A, or more: W is the inset, x the right end of its gap",
           (at_least(x, h), at_least(k, W)), at_least(x - W, h - k)),
    states("layers.place-middle", "so is the middle", (at_least(D, 2 * h), at_least(k)), at_least(D / 2, h - k)),
]
ROW = triangle("layers.row", "A, the first of a row, d farther, e high, and the first of the row k above",
               (at_least(k, 1), at_least(e, k), at_least(d), at_least(x, e + k)),
               (A, spot(x + d, e), spot(x, e + k)), KEPT, SOME)
# Two neighbours (0,0) and (d,0), the next row k above, upside down: from -c, not more than k, to d + b.
FOUR = (at_least(k, 1), at_least(d, 2), *within(c, 0, k))
QUAD = triangle("layers.quad-near", "two neighbours d apart and the vertex c before, in the next row", FOUR,
                (spot(0, 0), spot(d, 0), spot(-c, k)), KEPT, SOME)
QUAD += triangle("layers.quad-far", "the further neighbour and the two of the next row", (*FOUR, at_least(b)),
                 (spot(d, 0), spot(d + b, k), spot(-c, k)), KEPT, SOME)
TOP = triangle("layers.top", "A, B and the last row", (at_least(k, 1), at_least(x, k), at_least(D, x + k)),
               (A, spot(D, 0), spot(x, k)), KEPT, SOME)
# In units of `repaired_pieces`: t is f* over the height.
SPLIT = [bounded("layers.split", "(A, u, B), A B of F or more, and less than w; u at most v beside its far end",
                 (*SMALL, at_least(D, SEPARATION / FEATURE * t), at_least(GAP / FEATURE * t, D), at_least(v),
                  at_least(2 + D, v)),
                 lambda factor: at_least(D * D, square(factor) * (TUBE_FEATURE / FEATURE * t)**2 * (1 + v * v)),
                 Hint(degrees=(2, 3, 4, 5, 6)))]
SPACING = mpq(503, 10000)
# log2 17 < 4.09. R is 1 + the logarithm of the number of gaps, rounded up; there are at most 17 n gaps.
assert 17**100 < 2**409
BOUND = [
    states("layers.narrow", "gaps of 2.17 f* or more, f* = t", (at_least(W, mpq(217, 100) * t), at_least(t, FEATURE)),
           at_least(W, 2 * SPACING)),
    states("layers.along", "gaps of the Tube", (at_least(W, ALONG),), at_least(W, 2 * SPACING)),
    states("layers.spacing", "3/5 q is above 0.0223", (at_least(k, SPACING),), at_least(KEPT * k, TUBE_FEATURE)),
    bounded("layers.bound", "l = log2 n; R + 1 is below 3 + log2 (17 n): what 3/5 g/(R + 1) allows",
            (at_least(l, 2), at_least(mpq(709, 100) + l, r)),
            lambda factor: at_least(PROPER_LOGARITHM * KEPT * LEVEL * (1 + l), mpq(factor) * r * (1 + UNIT_SLACK))),
    states("layers.bound-few", "what 0.0223 allows", (at_least(l, 2),),
           at_least(PROPER_LOGARITHM * TUBE_FEATURE * (1 + l), 1 + UNIT_SLACK)),
]
STATEMENTS = [*TOOTH, *BETWEEN, *END, *ROW, *QUAD, *TOP, *SPLIT, *BOUND]

# What a proper mesh has for the leaves of `repaired_interior`.
SAME, PIECE, SHORT = "the same", "split, fan or layers", "split, fan or layers; `layers.split` where D < w"
PROPER = {
    "wedge: W1, W2, W3": SAME, "nothing left": SAME, "triangle left: A0": SAME, "triangle left: W4": SAME,
    "quadrilateral left: A2, A3": SAME, "quadrilateral left: W4, then R or W4": SAME,
    "one T-vertex between cross edges: C": SAME, "piece under one anchor: fan": SAME,
    "between cross edges: D >= w": PIECE, "piece with 1 of the legs: D >= w": PIECE,
    "piece with 2 of the legs: D >= w": PIECE, "piece with 1 of the legs: D >= w or F off one leg": SHORT,
    "piece with 2 of the legs: D >= w or F off one leg": SHORT, "piece with 2 of the legs: F off one leg": SHORT,
    "piece with 2 of the legs: both legs outwards": SHORT}
assert set(PROPER) == set(LEAVES)

ROWS = (
    "Layers: let the fans of A and B leave some gaps. The first one left ends beyond h (in the Interior beyond 2 h); "
    "an apex is inset by half its gap or by k, and otherwise stands as near to D/2 as it can. So the first is h - k "
    "from A or more (`place`), and neighbours are 2 or more apart; so are those of the next rows, where a vertex is "
    "over two neighbours, inset by 1 or more from both, or straight over the last one. Rows 1 to R, the last with one "
    "vertex, are h - k to k high: the first of a row is not nearer to A than it is high. Two neighbours p < q, not "
    "under one vertex: if D/2 >= p, the vertex over p is inset from p by k at most, as it stands as near to D/2 as it "
    "can; if D/2 <= q, so is the one over q, or it is straight over. The better diagonal is taken. ")
CASES = (
    "Of candidates the first that has f* is taken, or the best. Interior: trapezoids are cut as in a nonproper mesh, "
    "so the leaves of `repaired_interior` are those here. A piece: where `repaired_interior` takes a split or a fan, "
    "D >= w, so here. Where it nests, D > 4 H: layers with fans that reach 2 H; turned over, they are what is given "
    "with h = H, gaps w or `narrow`; what the fans have is as there. D < w: the split at any T-vertex u of the piece, "
    "2 H at most beside A B: (A, u, B) has `split`, the fans K1, and K2 where the gap at a leg is short. Tube: as for "
    "`repaired.tube-feature-45`, but layers along e take the place of what is nested, for e' with vertices on it and "
    "no fan over all of it: the fans reach h, gaps are `along`. ")
COUNT = (
    "R = 1 + ceil(log2 N) for N gaps. Q has at most 8 vertices a corner. T-vertices of one side are vertices of Q. On "
    "e' chord ends are on different levels, each with a vertex of Q on its chord (`repaired.chord-touch`); feet are "
    "straight below or above different vertices of Q, as the inside is on one side of e'. So N <= 16 n + 1 <= 17 n. "
    "The mesh is a proper triangulation (`theorem-2.triangulation`): a shortest way from a vertex to an edge without "
    "it is within a face; it is a height or longer, or the face is not meshed, and it is one in P. Bare triangles are "
    "faces of P; n >= 4, else there is nothing but one. ")
GROUP = "layers"
NAMES = (*(statement.id for statement in STATEMENTS), "pieces.k1", "pieces.k2", "pieces.k3", "pieces.narrow")
RESTS_ON = ("repaired.unit", "repaired.chord-touch", "repaired.interior-feature", "repaired.tube-feature-45",
            "theorem-2.triangulation")
WORDS = ROWS + CASES + COUNT
O_OF = ("By `repaired.proper-degradation-22` the repaired construction makes one of degradation at most 22 (1 + log2 "
        "c), c the number of corners of all faces, ")
MINE = "repaired.proper-degradation-22"
FOUND = f"{len(STATEMENTS)} problems, {sum(LEAVES.values())} leaves; the worst found is 8.04 (1 + log2 n)"
THEOREMS = [
    Theorem(MINE, "claim", "a proper mesh has degradation 22 (1 + log2 n) at most", NAMES, WORDS, FOUND, RESTS_ON),
    Theorem("theorem-2.degradation", "claim", "degradation 22 (1 + log2 n) at most for every polygon", NAMES,
            O_OF + "here n; triangles have degradation 1.", FOUND, (MINE,)),
    Theorem("table-1.proper", "claim", "degradation 22 (1 + log2 n) at most for every polygon", NAMES,
            O_OF + "here n; triangles have degradation 1.", FOUND, (MINE,)),
    Theorem("abstract.proper", "claim", "degradation 22 (1 + log2 (6 n)) at most, of all bounded faces", NAMES,
            O_OF + "here 6 n at most: two an edge, of which there are 3 n - 6 at most, and one an isolated vertex; "
            "less than four corners are one triangle, which stays.", FOUND, (MINE,)),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
