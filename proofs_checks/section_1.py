"""Prove `section-1.rectangle`, `section-1.regular-polygon`, `section-1.steiner-needed`, `table-1.classic`; refute
`section-1.vertex-error`.

Given   rectangle: (0,0), (r,0), (r,1), (r/2 + 1/2, 1), (r/2 - 1/2, 1), (0,1), r >= 3, of mfs 1.
        regular n-gon, n >= 4: a vertex at (1,0), its neighbours at (c,s) and (c,-s), c^2 + s^2 = 1, 0 <= c < 1. Its mfs
        is the length of its sides.
        vertex error: the unit square, of mfs 1; (0,0) moves by e to the right, (1,0) and (1,1) by e to the left.
Claim   rectangle: the third corner of the triangle on the edge between the midway vertices is (0,0) or (r,0), and the
        other midway vertex is at most 2/r from its side: the degradation is at least r/2, in full
        sqrt(((r + 1)/2)^2 + 1).
        regular n-gon: every triangulation has an ear, with the height 1 - c over the chord; side^2 = 2 (1 - c), so
        side/height is sqrt(2/(1 - c)), which is 1/sin(pi/n) for c = cos(2 pi/n); it is at least n/4, as the sides of
        an inscribed polygon are together shorter than the square around the circle: n side <= 8.
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

r, c, s, n, side, e = variables("r c s n side e")
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
RECTANGLE = tuple(f"section-1.rectangle-{name}" for name in (
    "foot-after", "foot-before", "distance", "exact-least", "exact-most"))
EAR = tuple(f"section-1.ear-{name}" for name in (
    "side-least", "side-most", "height-least", "height-most", "ratio"))
BY_THE_EDGE = ("The triangle on the edge between the midway vertices has its third corner at a lower corner: the other "
               "vertices are on the same line. The two cases are mirror images.")
BY_AN_EAR = ("Every triangulation of a polygon has an ear, and in the regular n-gon all ears are congruent. Its mfs is "
             "its side for n >= 4: a vertex sees the edges beside its neighbour at that vertex, and is farther from "
             "others. The perimeter of an inscribed polygon is below 8.")
GROUP = "section-1"
THEOREMS = [
    Theorem("section-1.rectangle", "claim", "degradation at least r/2, exactly sqrt(((r + 1)/2)^2 + 1)", RECTANGLE,
            BY_THE_EDGE, "attained by the best triangulation: `exactmesh reproduce table1`"),
    Theorem("section-1.regular-polygon", "claim", "degradation at least n/4, exactly 1/sin(pi/n)", EAR, BY_AN_EAR,
            "attained by the best triangulation, within the error of rational points: `exactmesh reproduce table1`"),
    Theorem("section-1.steiner-needed", "claim", "without Steiner points the degradation of regular n-gons is at least "
            "n/4", EAR, BY_AN_EAR, "attained, as for `section-1.regular-polygon`"),
    Theorem("table-1.classic", "corrected", "at least n/4 on regular polygons and r/2 on rectangles",
            (*EAR, *RECTANGLE), f"{BY_AN_EAR} {BY_THE_EDGE}", "both are attained"),
    Theorem("section-1.vertex-error", "refuted", "on the unit square an error of half the mfs puts a vertex on an edge",
            ("section-1.half-the-mfs",), "The vertices move by e along the lower side, those of the right edge to the "
            "left: each by less than the mfs, which is 1.", "half the mfs is the limit: `lemma-2.perturbation`"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
