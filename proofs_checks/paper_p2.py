"""Prove what Section 2 says of P2 and of the steps to P3, P5 and P6: `section-2.p2-single-curve`,
`section-2.arc-below-180`, `section-2.p3-refinement`, `appendix-a.both-ends-reflex`, `section-2.p5-grid`,
`section-2.p5-tiles`, `section-2.p6-tiles`.

Given   mfs(P) = 1. At a corner the edge e runs from p = (0,0) along the x-axis, P above it; e' is its parallel at 1/4.
        Convex corner: the other edge f leaves in the direction (k^2 - 1, 2 k)/(k^2 + 1), k = cot(w/2), w the angle; e'
        begins at (k/4, 1/4); a straight corner has k = 0. f is 1 long or longer, and (k^2 + 1)/(2 k) where w is acute
        (Appendix A).
        Reflex corner: f is below the x-axis. An arc about p goes from (0,1) to the unit normal (c,d) of the other edge,
        both divided by 4; s, c are the sine and cosine of its angle.
Claim   corner: (y, 1/4) is 1/4 or more from the line of f iff y >= k/4, and nearer than 1/4 to f for 0 <= y < k/4.
        reflex: e' is 1/4 from the half-plane of f, and from f itself at most at (0, 1/4).
        arc: c > -1. Prolonged: both edges reach (b, 1/4), b = (1 - c)/(4 s), 0 < b <= 1/4.
        both reflex: e' is as long as e. P5: ends of chords are on the level of their vertex; edges that span two levels
        are in the same order on all levels between. P6: Lemma 1's vertex turns left with each side of a trapezoid.
Method  linear, but for the unit circle.
Tight   equalities at the ends of e'.
By hand that a nearest point is inside an edge or a reflex vertex; that points of a simple polygon on a level without
        vertices are inside by the parity of the number of edges before them.
"""

from gmpy2 import mpq
from kit import Hint, Spot, Statement, Theorem, at_least, bounded, cross, equal, main, more, spot, square, states
from refinement import APPENDIX, NEAREST

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables

y, k, x, z, c, d, s, b, L, u, v, g, j, t = variables("y k x z c d s b L u v g j t")
l, h, m = variables("l h m")  # noqa: E741
QUARTER = mpq(1, 4)
LINE = 2 * k * y - (k * k - 1) / 4  # k^2 + 1 times the distance of (y, 1/4) from the line of f
FOOT = y * (k * k - 1) + k / 2
CLOSE = (more(k), at_least(y), more(k, 4 * y))

CORNER = [
    states("p2.corner-far", "e' is 1/4 or more from f", (at_least(k), at_least(4 * y, k)),
           at_least(LINE, (k * k + 1) / 4), Hint(degrees=(2,))),
    states("p2.corner-near", "before e' begins it is nearer than 1/4 to the line of f", CLOSE,
           more((k * k + 1) / 4, LINE), Hint(degrees=(2,))),
    states("p2.corner-near-too", "also from the other side of it", CLOSE, more(LINE, -(k * k + 1) / 4),
           Hint(degrees=(2,))),
    states("p2.corner-foot", "with the foot after p", CLOSE, more(FOOT),
           Hint(degrees=(2, 3, 4), cases=(at_least(k, 1),))),
    states("p2.corner-foot-acute", "and before the end of f, w acute", (*CLOSE, at_least(k, 1)),
           at_least((k * k + 1)**2, 2 * k * FOOT), Hint(degrees=(4,), squares=(k, k * k))),
    states("p2.corner-foot-obtuse", "or not", (*CLOSE, at_least(1, k)), at_least(k * k + 1, FOOT),
           Hint(degrees=(2, 3), squares=(k,))),
]
REFLEX = [
    bounded("p2.reflex", "points below the x-axis are 1/4 or more from e'", (at_least(0, z),),
            lambda f: at_least((x - y)**2 + (QUARTER - z)**2, square(f) / 16), Hint(degrees=(2,), squares=(x - y, z)),
            {"x": "0", "y": "0", "z": "0"}),
    states("p2.arc-foot", "(y, 1/4) is 1/4 from p only for y = 0", (at_least(mpq(1, 16), y * y + mpq(1, 16)),),
           at_least(0, y * y)),
]
ARC = [
    states("p2.arc", "unit normals (1,0) and (c,d) of a right turn: their cosine is above -1",
           (equal(c * c + d * d, 1), more(-d)), more(c, -1), Hint(degrees=(2,))),
    states("p2.prolonged-beyond", "b s + c/4 = 1/4, an arc below 90 degrees: b > 0",
           (equal(s * s + c * c, 1), more(s), more(c), equal(4 * b * s, 1 - c)), more(b), Hint(degrees=(2, 3))),
    states("p2.prolonged-reach", "and b <= 1/4", (equal(s * s + c * c, 1), more(s), at_least(c),
                                                 equal(4 * b * s, 1 - c)), at_least(1, 4 * b), Hint(degrees=(2, 3))),
]
BOTH = [states(f"p2.both-reflex-{name}", "ends of e' above the ends of e, (0,0) and (L,0): the same length",
               (more(L), equal(u * L, 0), equal((v - L) * L, 0)), conclusion, Hint(degrees=(3, 4)))
        for name, conclusion in (("least", at_least(L * (v - u), L * L)), ("most", at_least(L * L, L * (v - u))))]
P5 = [
    *(states(f"p2.p5-grid-{name}", "the end z of a chord is on the level y = j g of its vertex",
             (equal(y, j * g), equal(z - y, 0)), conclusion)
      for name, conclusion in (("least", at_least(z, j * g)), ("most", at_least(j * g, z)))),
    states("p2.order", "edges from y to z and from x to u, y <= x and z <= u, one strictly: y z is first in between",
           (at_least(x, y), at_least(u, z), more(x + u, y + z), more(t), more(1, t)),
           more((1 - t) * x + t * u, (1 - t) * y + t * z), Hint(degrees=(3,))),
]


def inside(case: str, hypotheses: tuple[Constraint, ...], corners: list[Spot], centre: Spot) -> list[Statement]:
    """Return that the centre turns left with each side."""
    return [states(f"p2.{case}-{name}", f"Lemma 1, {case}: the vertex is to the left of the {name} side", hypotheses,
                   more(cross(corners[(i + 1) % 4].minus(corners[i]), centre.minus(corners[i]))))
            for i, name in enumerate(("lower", "right", "upper", "left"))]


# The frames of `lemma_1.py`: from (0,0) to (l,0), from (-b,h) to (l + m,h) or from (b,h) to (b + l + m,h).
SIZES = (more(l), more(h), at_least(b), at_least(m))
P6 = [
    *inside("case-1", SIZES, [spot(0, 0), spot(l, 0), spot(l + m, h), spot(-b, h)], spot(l / 2, h / 2)),
    *inside("case-2", SIZES, [spot(0, 0), spot(l, 0), spot(b + l + m, h), spot(b, h)], spot((b + l) / 2, h / 2)),
]
STATEMENTS = [*CORNER, *REFLEX, *ARC, *BOTH, *P5, *P6]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


WINDING = ("Faces that turn left, whose directed sides cancel but for the boundary of a region, tile it: about any "
           "point their winding numbers, 1 inside and 0 outside, add up to that of the boundary. ")
SIMPLE = "In a simple polygon no edge turns back, so at a reflex corner it turns right. "
GROUP = "paper-p2"
THEOREMS = [
    Theorem("section-2.p2-single-curve", "claim", "the points of P at distance 1/4 from its boundary are one closed "
            "curve of a segment an edge and an arc a reflex vertex", (
                *names(CORNER, REFLEX, NEAREST), *APPENDIX, "lemma-2.triangle-inequality", "lemma-2.distance-left"),
            "Let x be in the curve of the segments e' and the arcs, which are not empty (Appendix A), and a the "
            "nearest point of e, or v. Edges and vertices without a common vertex are 1 apart, and so 3/4 from x; the "
            "edges that meet e or v are 1/4 away or more by the problems. So x is at distance 1/4, inside, as nothing "
            "is between it and a, and in no two parts but at their common end. Conversely, let x in P be at distance "
            "1/4 from a on its boundary. If a is inside an edge e, x is in e', as it would be nearer to the edge next "
            "to e. If a is a vertex, x is at 90 degrees or more to both edges, so a is reflex and x in its arc.",
            "the distance is 1/4 throughout"),
    Theorem("section-2.arc-below-180", "claim", "the cosine of an arc's angle is above -1", names(ARC[:1]), SIMPLE +
            "The arc goes from one normal to the other, turned so that the first is (1,0).", "180 degrees is the "
            "limit"),
    Theorem("section-2.p3-refinement", "claim", "arcs above 90 degrees have a middle, and edges beside arcs below 90 "
            "degrees meet beyond the ends of the arc", names(ARC), SIMPLE + "An arc below 180 degrees has one middle, "
            "which two chords join to its ends. The line of the other edge's parallel has the normal (s,c) and the "
            "distance 1/4 from v: so it meets y = 1/4 at x = b."),
    Theorem("appendix-a.both-ends-reflex", "claim", "|e'| = |e|", names(BOTH), "At a reflex corner e' ends where its "
            "arc does, at right angles to e.", "an equality"),
    Theorem("section-2.p5-grid", "claim", "all vertices of P5 are on levels", names(P5[:2]), "Vertices of P4 were put "
            "on levels; chords are horizontal and begin at vertices of P4."),
    Theorem("section-2.p5-tiles", "claim", "the inside of P4 is cut into trapezoids with two level "
            "sides", names(P5[2:]),
            "Between neighbouring levels with vertices of P4 its edges do not meet and keep their order; by parity "
            "what is between the first and the second, the third and the fourth .. is inside. Such parts of "
            "neighbouring levels are joined where no vertex of P4 is on what they share: there they have the same "
            "legs.",
            "", ("section-2.p4-feature-size",)),
    Theorem("section-2.p6-tiles", "claim", "the faces at Lemma 1's vertices, and triangles as they are, tile P5",
            names(P6), WINDING + "Turned and mirrored as in Lemma 1; T-vertices are on the parallel sides, in the "
            "faces of these. Around the vertex directed sides cancel: v s is in one face, s v in the next.",
            "", ("section-2.p5-tiles",)),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
