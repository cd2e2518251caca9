"""Prove what Section 5 says that does not rest on a particular triangulation: `section-5.lower-bound`,
`section-5.vertical-line`, `section-5.overlay`, `section-5.scaling`; refute and correct `section-5.epsilon`
and `section-5.strip`.

Given   The dissection of docs/dissection.md, of triangles of total area 1: a triangle on its longest side w, of height
        H, becomes a rectangle w x h, h = H/2, which its sides cut where x <= f w/2 and where x >= (1 + f) w/2 only.
        Slices of a height g, e <= g < 2 e, become cells of height e and width v = w g/e by a slide along the line from
        (0, g) to (v, 0), and a move of what is below it and above e.
Claim   epsilon: the polygon (0,0), (1,-2), (2,0), (5,-4), (8,0), (8,4) is cut, without Steiner points, into triangles
        with the corners 0 1 2, 2 3 4, 0 4 5, of heights of 16/5 squared or more; (2,0) is 4/5 squared from x = 2 y.
        Heights are at least the ifs in any triangulation: the least one stands inside its side.
        strip: C n A/epsilon is below 1 for a square of side z < 1/(12 C); at area 1 there are at most 6 t/e pieces of
        t triangles.
        overlay: cells N_a, N_b, of 9 parts each, that cross at most 49 times where they overlap, and 6 times more each,
        make at most 64 (N_a + N_b) pieces.
        scaling: a polygon of diameter D has area at most D^2.
        lower bound: N pieces no wider than the square of area r, which cover the long side of r x 1: 2 N^2 >= r.
Method  linear, but for the triangle on its longest side.
Tight   scaling by the factor D^2/A only; the others are not.
By hand the count of docs/dissection.md, whose steps every run asserts.
"""

from gmpy2 import mpq
from kit import Hint, Statement, Theorem, at_least, bounded, equal, main, more, refuted, square, states

from exactmesh.proofs.polynomial import variables

x, y, w, t, z, C, e, A, D, a, b, s, f, g, v, q, k = variables("x y w t z C e A D a b s f g v q k")
N, M, P, c, d, r, n, u = variables("N M P c d r n u")
LONGEST = (more(w), more(y), at_least(w * w, x * x + y * y), at_least(w * w, (w - x)**2 + y * y))

EPSILON = [
    refuted("section-5.t-vertex", "a vertex (t, 0) is as far from the line x = 2 y as the least height, squared",
            (more(t), at_least(8, t)), at_least(t * t, 16), {"t": "2"}),
    states("section-5.foot-inside", "the foot of the height onto a longest side is not before it", LONGEST, at_least(x),
           Hint(degrees=(2, 3))),
    states("section-5.foot-inside-too", "nor beyond it", LONGEST, at_least(w, x), Hint(degrees=(2, 3))),
]
STRIP = [
    states("section-5.small-square", "4 C A/e < 1 for A = z^2, e >= z/3, z < 1/(12 C)",
           (more(C), more(z), more(e), at_least(3 * e, z), more(1, 12 * C * z)), more(e, 4 * C * z * z)),
    bounded("section-5.longest-side", "4 H^2 <= 3 w^2 over a longest side w", LONGEST,
            lambda factor: at_least(3 * w * w / square(factor), 4 * y * y),
            Hint(degrees=(2,), squares=(2 * x - w,)), {"x": "56", "y": "97", "w": "112"}),
    states("section-5.height", "H <= 4/3 for an area w H/2 <= 1",
           (more(w), more(y), at_least(3 * w * w, 4 * y * y), at_least(2, w * y)), at_least(4, 3 * y),
           Hint(degrees=(3, 4))),
    bounded("section-5.parts", "9 parts of each of q <= H/(2 e) slices are at most 6/e",
            (more(e), at_least(q), at_least(4, 3 * y), at_least(y, 2 * e * q)),
            lambda factor: at_least(6, 9 * q * e * mpq(factor)), Hint(degrees=(2, 3)),
            {"e": "1", "y": "4/3", "q": "2/3"}),
]
LINE = [
    states("section-5.one-side", "no line is in both parts that the sides cut",
           (more(w), at_least(f), at_least(f * w / 2, u), at_least(u, (1 + f) * w / 2)), None, Hint(degrees=(1, 2))),
    states("section-5.slide-least", "what is above the slanted line slides along it: v - w across, e - g up",
           (more(e), more(w), equal(v * e, w * g)), at_least(v * (g - e), g * (v - w)), Hint(degrees=(2,))),
    states("section-5.slide-most", "and not less steeply", (more(e), more(w), equal(v * e, w * g)),
           at_least(g * (v - w), v * (g - e)), Hint(degrees=(2,))),
    states("section-5.end", "what is below the line and above e is v - w wide or less, at most w",
           (more(e), more(w), at_least(g, e), more(2 * e, g), equal(v * e, w * g)), at_least(w, v - w),
           Hint(degrees=(2,))),
]
OVERLAY = [bounded(
    "section-5.overlay", "pairs P of cells that overlap, crossings c, and parts: pieces k <= 9 (N + M) + c",
    (at_least(N, 1), at_least(M, 1), at_least(N + M - 1, P), at_least(49 * P + 6 * (N + M), c),
     at_least(9 * (N + M) + c, k)), lambda factor: more(64 * (N + M), k * mpq(factor)),
    sharp={"N": "100", "M": "100", "P": "199", "c": "10951", "k": "12751"})]
SCALING = [bounded(
    "section-5.scaling", "a factor s with s^2 A = 1 is at least 1/D: A <= a b, the sides of a box around it, a, b <= D",
    (more(D), more(s), at_least(a), at_least(D, a), at_least(b), at_least(D, b), at_least(a * b, A),
     equal(s * s * A, 1)),
    lambda factor: at_least(s * s * D * D, square(factor)), Hint(degrees=(4,)),
    {"D": "1", "s": "1", "a": "1", "b": "1", "A": "1"})]
LOWER = [bounded(
    "section-5.lower-bound", "N pieces of width d, d^2 <= 2 r, cover a side of length r: 2 N^2 >= r",
    (more(r), more(N), more(d), at_least(2 * r, d * d), at_least(N * d, r)),
    lambda factor: at_least(2 * N * N, r * square(factor)), Hint(degrees=(4, 5), squares=(r, N * d)),
    {"r": "2", "d": "2", "N": "1"})]
PIECES = [
    states("section-5.height-squared", "H^4 <= 3 T^2 for the area T = w H/2 of a triangle on its longest side",
           (more(w), more(y), at_least(3 * w * w, 4 * y * y)), at_least(3 * (w * y / 2)**2, y**4), Hint(degrees=(4,))),
    states("section-5.sum", "Cauchy, one more: S^2 <= t Q gives (S + H)^2 <= (t + 1)(Q + H^2)",
           (at_least(t, 1), at_least(x), at_least(t * z, x * x)), at_least((t + 1) * (z + y * y), (x + y)**2),
           Hint(degrees=(4,), squares=(x - t * y,))),
    states("section-5.cells", "N <= S/(2 e), S^2 <= sqrt(3) 72 n A, A <= D^2, e > 64/129 of a height, 45 of them D/r: "
           "N <= 294 n r", (at_least(n, 3), at_least(N), more(w), more(r), more(x), more(D), equal(D, r * w),
                            at_least(129 * 45 * x, 128 * N * w), at_least(126 * n * D * D, x * x)),
           at_least(294 * n * r, N), Hint(degrees=(5, 6))),
]
STATEMENTS = [*EPSILON, *STRIP, *LINE, *OVERLAY, *SCALING, *LOWER, *PIECES]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


CELLS = ("What lies in one slide's part is a translate of a part of the slice, where a vertical line meets one of the "
         "triangle's two sides or none. ")
MANY = "at most 55 * 294 k (sum of n)(sum of r) pieces of k polygons"
BY_CELLS = CELLS + ("docs/dissection.md: k strips of N cells in all make at most 55 k N pieces; the cells of t "
                    "triangles, of heights H and total area A, are at most (sum of H)/(2 e), and (sum of H)^2 <= t "
                    "(sum of H^2) by induction, <= sqrt(3) t A. e is more than 128/129 of half the least height. A "
                    "polygon with n corners has 72 n triangles at most, as their angles add up, each of a height of "
                    "mfs/45 or more: in the polygon with the least one, r is the spread and A <= (r mfs)^2.")
LESS = "6875 k is asserted on every run"
MESHES = ("repaired.steiner-count", "abstract.nonproper", "section-5.overlay")
GROUP = "section-5"
THEOREMS = [
    Theorem("section-5.epsilon", "refuted", "the ifs of a nonproper triangulation can be less than its heights",
            names(EPSILON[:1]), "The triangles of the polygon in the script have squared least heights of 64/5, 16/5 "
            "and 16; (2,0), on a side of the largest, is 4/5 squared from its side to (8,4), which it sees. The text "
            "allows nonproper triangulations."),
    Theorem("section-5.epsilon", "corrected", "heights are at least the ifs, with equality if proper",
            (*names(EPSILON[1:]), "section-1.height"), "The least height of a triangle is onto a longest side, and "
            "inside the triangle it ends on an edge without its vertex. Equality: `section-1.heights`."),
    Theorem("section-5.strip", "refuted", "a small square has fewer than one piece", names(STRIP[:1]),
            "Two right triangles, n = 4, half of their heights is z/(2 sqrt 2) > z/3; there is one piece at least, "
            "whatever the constant C."),
    Theorem("section-5.strip", "corrected", "t triangles of total area 1 make at most 6 t/epsilon pieces",
            names(STRIP[1:], LINE), "docs/dissection.md: a slice is cut in three by the slide, and each part in three "
            "by the triangle's sides, which do not cross. Without Steiner points a polygon has n - 2 triangles."),
    Theorem("section-5.vertical-line", "claim", "a vertical line meets at most 3 cuts of a strip, if it contains "
            "none and no corner", names(LINE), CELLS + "A line off x = w meets two of the three parts of the slide, "
            "one above the slanted line and one below: so at most 1 + 2 cuts."),
    Theorem("section-5.overlay", "claim", "the strips of two polygons make at most 64 times as many pieces as cells",
            names(OVERLAY, LINE), CELLS + "The rest is docs/dissection.md: cells of two strips that overlap, cuts that "
            "cross at most once, 7 in a cell that are not upright and 2 that are; pieces are counted by their least "
            "corners, which are those of a part or crossings. Each strip has as many pieces as cells, or more."),
    Theorem("section-5.pieces", "claim", MANY, names(PIECES, OVERLAY, LINE), BY_CELLS, LESS, MESHES),
    Theorem("section-5.pieces-many", "claim", MANY, names(PIECES, OVERLAY, LINE), BY_CELLS, LESS, MESHES),
    Theorem("section-5.scaling", "claim", "the factor 1/sqrt(A) is at least 1/D", names(SCALING),
            "A polygon of diameter D is in a box no wider and no higher than D. Its area is positive.",
            "the constant is not best: A <= pi D^2/4"),
    Theorem("section-5.lower-bound", "claim", "at least sqrt(r/2) pieces", names(LOWER), "The square has the area r; "
            "the points of a long side of the rectangle that are in a piece are in an interval no longer than the "
            "square's diameter, and the pieces cover that side."),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
