"""Prove `section-1.rectangle`, `section-1.regular-polygon`, `section-1.steiner-needed`, `section-1.bounded-faces`,
`table-1.classic`, `section-1.heights`, `section-1.drawing`; refute `section-1.vertex-error`, `section-1.faces-apart`.

Given   rectangle: (0,0), (r,0), (r,1), (r/2 + 1/2, 1), (r/2 - 1/2, 1), (0,1), r >= 3, of mfs 1.
        regular n-gon, n >= 4: a vertex at (1,0), its neighbours at (c,s) and (c,-s), c^2 + s^2 = 1, 0 <= c < 1. Its mfs
        is the length of its sides.
        vertex error: the unit square, of mfs 1; (0,0) moves by e to the right, (1,0) and (1,1) by e to the left.
        k: a bound for the vertices of a face, k >= 3; there are no Steiner points. Rectangle: k - 1 midway vertices,
        unit distance apart, r >= 2 k; n-gon: n >= 2 k. Table 1: n - 4 of them, n >= 6, r >= 2 n: an n-gon of spread
        sqrt(r^2 + 1).
        heights: a vertex v at the origin, the opposite side of a triangle at v on the line y = h.
        drawing: vertices and edges are drawn as all points nearer than t/2.
        faces apart: the square (0,0), (4,0), (4,4), (0,4) with the edge from (2 - e/2, 2) to (2 + e/2, 2) inside,
        0 < e <= 1. Every vertex is farther from the edges without it than 3/2, the mfs by the text's definition.
Claim   rectangle: the third corner of the triangle on the edge between the midway vertices is (0,0) or (r,0), and the
        other midway vertex is at most 2/r from its side: the degradation is at least r/2, in full
        sqrt(((r + 1)/2)^2 + 1).
        regular n-gon: every triangulation has an ear, with the height 1 - c over the chord; side^2 = 2 (1 - c), so
        side/height is sqrt(2/(1 - c)), which is 1/sin(pi/n) for c = cos(2 pi/n); it is at least n/4, as the sides of
        an inscribed polygon are together shorter than the square around the circle: n side <= 8.
        bounded faces: a face that meets one chord only has a vertex beside that chord's end, at distance at most
        (k - 2) sin(pi/n) side from it: degradation n/(4 (k - 2)). Rectangle: some chord ends in a midway vertex u, X >=
        (r - k + 4)/2 beside its other end, with a neighbour of u above it, 1/sqrt(X^2 + 1) away: r/4.
        Table 1: (n + r)/6 for these rectangles, and for regular n-gons with their spread as r.
        heights: all points of the opposite side are h away, or more.
        drawing: nothing is drawn over anything else that it does not touch iff t is at most the mfs.
        faces apart: in a mesh the ends of the edge are at distance e from an edge without them, or less.
        vertex error: with an error of 1/2, half the mfs, the corner (0,0) lies on the edge.
Method  identities, and combinations with nonnegative coefficients.
Tight   both lower bounds are attained (`exactmesh reproduce table1`).
By hand that mfs of a regular n-gon, n >= 4, is its side; that every triangulation of a polygon has an ear; that the
        sum over families is the asymptotic statement.
"""

from gmpy2 import mpq
from kit import (
    Hint,
    Statement,
    Theorem,
    at_least,
    bounded,
    cross,
    dot,
    equal,
    main,
    more,
    refuted,
    spot,
    square,
    states,
)

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables

r, c, s, n, side, e, k, X, m, x, y, t, sm, cm, d = variables("r c s n side e k X m x y t sm cm d")
ax, ay, bx, by, D = variables("ax ay bx by D")
ONE = mpq(1)
LEFT, RIGHT = spot(r / 2 - mpq(1, 2), 1), spot(r / 2 + mpq(1, 2), 1)
CORNER = spot(r, 0)
DIAGONAL, GAP = LEFT.minus(CORNER), RIGHT.minus(CORNER)
ROOM = (at_least(r, 3),)
CIRCLE = (equal(c * c + s * s, 1), at_least(c), more(1, c))
CHORD = spot(0, 1)  # the direction from (c,-s) to (c,s)
APEX = spot(1 - c, s)  # from (c,-s) to (1,0)
SIDE = (more(side), more(n), at_least(8, n * side))
HEIGHT = side * side / 2  # of an ear: 1 - c, and side^2 = 2 (1 - c)



def equals(id_: str, says: str, hypotheses: tuple[Constraint, ...], p: Polynomial, q: Polynomial) -> list[Statement]:
    """Return that two values are the same, as two inequalities."""
    return [states(f"{id_}-least", f"{says}, at least", hypotheses, at_least(p, q)),
            states(f"{id_}-most", f"{says}, at most", hypotheses, at_least(q, p))]


STATEMENTS = [
    states("section-1.rectangle-foot-after", "the foot of a midway vertex is not before the diagonal", ROOM,
           at_least(dot(GAP, DIAGONAL))),
    states("section-1.rectangle-foot-before", "nor beyond it", ROOM,
           at_least(dot(DIAGONAL, DIAGONAL), dot(GAP, DIAGONAL))),
    bounded("section-1.rectangle-distance", "its distance is at most 2/r", ROOM,
            lambda f: at_least(4 * dot(DIAGONAL, DIAGONAL) / square(f), (r * cross(DIAGONAL, GAP))**2)),
    *equals("section-1.rectangle-exact", "and is 1/sqrt(((r + 1)/2)^2 + 1)", ROOM,
            cross(DIAGONAL, GAP)**2 * ((r + 1)**2 / 4 + 1), dot(DIAGONAL, DIAGONAL)),
    *equals("section-1.ear-side", "the square of a side is 2 (1 - c)", CIRCLE, dot(APEX, APEX), 2 - 2 * c),
    *equals("section-1.ear-height", "the height of an ear is 1 - c", CIRCLE, cross(CHORD, APEX)**2, (1 - c)**2),
    bounded("section-1.ear-ratio", "a side is at least n/4 heights", SIDE,
            lambda f: at_least(4 * side / square(f), n * HEIGHT), Hint(degrees=(2, 3)),
            {"side": "1", "n": "8"}),
    refuted("section-1.half-the-mfs", "an error e below the mfs keeps (0,0) off the edge from (1,0) to (1,1)",
            (at_least(e), more(ONE, e)), more((1 - 2 * e)**2), {"e": "1/2"}),
]
FACES = (at_least(k, 3), at_least(r, 2 * k), at_least(2 * X, r - k + 4))
SPOKE, BESIDE = spot(X, 1), spot(X - 1, 1)
BOUNDED = [
    states("section-1.sine-of-multiples", "sin((m + 1) f) <= (m + 1) sin f, if sin(m f) <= m sin f",
           (at_least(s), at_least(1, c), at_least(1, cm), at_least(sm), at_least(m * s, sm)),
           at_least((m + 1) * s, sm * c + cm * s)),
    bounded("section-1.leaf-face", "a side is at least n/(4 (k - 2)) distances d <= (k - 2) s side, s = side/2 <= 4/n",
            (at_least(k, 3), more(n), more(side), at_least(s), at_least(4, n * s), at_least((k - 2) * s * side, d)),
            lambda f: at_least(4 * (k - 2) * side, n * d * mpq(f)), Hint(degrees=(3, 4)),
            {"k": "3", "n": "4", "side": "1", "s": "1", "d": "1"}),
    states("section-1.spoke-foot", "the foot of a neighbour 1 beside the end of a chord is on the chord", FACES,
           at_least(dot(SPOKE, SPOKE), dot(BESIDE, SPOKE)), Hint(degrees=(1, 2))),
    states("section-1.spoke-foot-after", "and not before it", FACES, at_least(dot(BESIDE, SPOKE)),
           Hint(squares=(X - 1,), degrees=(2,))),
    *equals("section-1.spoke-distance", "its distance is 1 over the chord's length", FACES,
            cross(BESIDE, SPOKE)**2, spot(1, 0).x),
    bounded("section-1.spoke-length", "a chord is r/4 long or longer", FACES,
            lambda f: at_least(16 * dot(SPOKE, SPOKE), square(f) * r * r), Hint(degrees=(2,))),
    states("section-1.table-rectangle", "with k = n - 3 midway vertices and one more, r >= 2 n: X >= (n + r)/6",
           (at_least(n, 6), at_least(r, 2 * n), at_least(2 * X, r - n + 7)), at_least(6 * X, n + r)),
    states("section-1.table-regular", "n/4 >= (n + r)/6 for r = 2/side, n side >= 5",
           (more(n), more(side), at_least(n * side, 5), equal(r * side, 2)), at_least(6 * n, 4 * (n + r)),
           Hint(degrees=(2, 3))),
]
HEIGHTS = [bounded("section-1.height", "the points of the opposite side are h away or more", (more(y),),
                   lambda f: at_least(x * x + y * y, square(f) * y * y), sharp={"x": "0", "y": "1"},
                   hint=Hint(squares=(x,), degrees=(2,)))]
DRAWN = [
    states("section-1.drawn-over", "a point nearer than t/2 to a and to b: a and b are nearer than t",
           (more(t), more(t * t, 4 * (ax * ax + ay * ay)), more(t * t, 4 * (bx * bx + by * by))),
           more(t * t, (ax - bx)**2 + (ay - by)**2), Hint(squares=(ax + bx, ay + by), degrees=(2,))),
    states("section-1.drawn-middle", "if a and b are nearer than t, their middle is nearer than t/2 to both",
           (more(t), more(t * t, x * x + y * y)), more(t * t / 4, (x / 2)**2 + (y / 2)**2)),
]
APART = [
    states("section-1.apart-mfs", "the mfs of the square with the edge is 3/2 or more", (more(e), at_least(1, e)),
           at_least(2 - e / 2, mpq(3, 2))),
    states("section-1.apart-worse", "for every D some e makes 3/2 larger than D e",
           (more(D), more(e), at_least(1, D * e)), more(mpq(3, 2), D * e)),
]
STATEMENTS += [*BOUNDED, *HEIGHTS, *DRAWN, *APART]
RECTANGLE = tuple(f"section-1.rectangle-{name}" for name in (
    "foot-after", "foot-before", "distance", "exact-least", "exact-most"))
EAR = tuple(f"section-1.ear-{name}" for name in (
    "side-least", "side-most", "height-least", "height-most", "ratio"))
BY_THE_EDGE = ("The triangle on the edge between the midway vertices has its third corner at a lower corner: the other "
               "vertices are on the same line. The two cases are mirror images.")
BY_AN_EAR = ("Every triangulation of a polygon has an ear, and in the regular n-gon all ears are congruent. Its mfs is "
             "its side for n >= 4: a vertex sees the edges beside its neighbour at that vertex, and is farther from "
             "others. The perimeter of an inscribed polygon is below 8.")
BY_A_LEAF = ("Chords cut a polygon into faces that make a tree; a face at its end has one chord and at most k - 1 "
             "sides. The side at an end of the chord makes an angle of j pi/n with it, 1 <= j <= k - 2: by induction "
             "over j, its other end is at most (k - 2) s side from the chord, with the foot on it because n >= 2 k.")
BY_A_CHORD = ("If chords at midway vertices went only from the first one to (0,0) and from the last one to (r,0), the "
              "face below them would have all of them and two more vertices, too many. Any other chord goes to a lower "
              "corner too, and its end has a midway neighbour on the side of that corner; X is least for the second.")


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


SPOKES = names(BOUNDED[2:7])
GROUP = "section-1"
THEOREMS = [
    Theorem("section-1.rectangle", "claim", "degradation at least r/2, exactly sqrt(((r + 1)/2)^2 + 1)", RECTANGLE,
            BY_THE_EDGE, "attained by the best triangulation: `exactmesh reproduce table1`"),
    Theorem("section-1.regular-polygon", "claim", "degradation at least n/4, exactly 1/sin(pi/n)", EAR, BY_AN_EAR,
            "attained by the best triangulation, within the error of rational points: `exactmesh reproduce table1`"),
    Theorem("section-1.steiner-needed", "claim", "without Steiner points the degradation of regular n-gons is at least "
            "n/4", EAR, BY_AN_EAR, "attained, as for `section-1.regular-polygon`"),
    Theorem("section-1.bounded-faces", "claim", "degradation at least n/(4 (k - 2)) on regular n-gons and r/4 on "
            "rectangles, for faces of at most k vertices", (*names(BOUNDED[:2]), *SPOKES, *EAR),
            f"{BY_A_LEAF} s <= 4/n as for triangles. {BY_A_CHORD}"),
    Theorem("table-1.classic", "claim", "at least (n + r)/6, for every n >= 6 and r >= 2 n on an n-gon of spread "
            "sqrt(r^2 + 1); so it is on regular n-gons, r their spread", (*names(BOUNDED[2:]), *EAR),
            f"{BY_A_CHORD} Here k = 3 and there are n - 4 midway vertices. {BY_AN_EAR} Their spread is at most 2/side, "
            "and n >= 4 sides are longer together than a square's, above 5. Both are convex: the ifs is the mfs."),
    Theorem("section-1.heights", "claim", "in a proper triangulation the ifs is at least the least height",
            names(HEIGHTS), "A segment from v inside P begins in a triangle at v, whose only vertices are its corners. "
            "It ends on the opposite side or crosses it, or runs along a side at v to the corner there: points of "
            "triangles at v that are on edges without v are on opposite sides.", "an equality: `section-5.epsilon`"),
    Theorem("section-1.drawing", "claim", "t is at most the mfs iff no vertex is drawn over a vertex or edge without "
            "it", names(DRAWN), "That no point is nearer than t/2 to a vertex and to a feature without it is, point by "
            "point, that they are t apart. Edges that do not meet are as far apart as an end of one from the other."),
    Theorem("section-1.faces-apart", "refuted", "without distances of two vertices in the mfs, some PSLGs have no "
            "mesh of bounded degradation", names(APART), "The ends u, v of the edge are e apart. In a mesh either "
            "there is a vertex on it, and u is nearer than e to the edge beyond; or u, a corner of triangles, is the "
            "end of another edge, and v is e from u on it, or nearer to it. So the mfs of any mesh is e at most."),
    Theorem("section-1.vertex-error", "refuted", "on the unit square an error of half the mfs puts a vertex on an edge",
            ("section-1.half-the-mfs",), "The vertices move by e along the lower side, those of the right edge to the "
            "left: each by less than the mfs, which is 1.", "half the mfs is the limit: `lemma-2.perturbation`"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
