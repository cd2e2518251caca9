"""Prove that the Tube is tiled: `phase-1.structure`, `tube.tiles`, `section-2.tube-keeps-boundary`,
`theorem-1.triangulation`.

Given   mfs(P) = 1; vertices of P4 moved by m <= 1/20 at most. B runs from L = (0,0) to R = (l,0), its edge of P4 from
        t = (p,h) to u = (q,k), which are above B; before snapping t was 1/4 or more before R along B, and u 1/4 or
        more after L. (c,e) is the direction of t u, e <= 0.3315, c >= 0.943; p >= -3/10, h >= 1/5.
        Q'' and its vertex s as in `paper_tube`, in units of the spacing.
Claim   structure: p < l, q > 0, and L, u, t or R, u, t turns left, as L, R, u and L, R, t do.
        cut: where L is not below the line of t u, the angle at t is 135 degrees or more, so phase 2 cuts nothing there.
        low: the four faces at s turn left.
Method  `assert_faces` adds up the directed sides of all faces over an edge of P, with up to LONGEST vertices on the top
        of which some are cut off on either side, and over a chord: left are B, the spokes and the top.
Tight   no bounds.
By hand that winding numbers add up: see `paper_tilings`.
"""

from itertools import pairwise, product

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, main, more, states
from paper_tall import THEOREMS as TALL
from paper_tilings import THEOREMS as TILINGS
from paper_tilings import boundary, path
from paper_tube import ANGLES, BESIDE_LOW, FLOOR, GAP, LEVELLED, LOW, PROJECTION, TILT, TURNS, names, v
from paper_tube import B as LENGTH
from paper_tube import h as height
from refinement import LEMMA_2
from refinement import THEOREMS as REFINED

from exactmesh.proofs.polynomial import variables

LONGEST = 6
p, q, h, k, l, p0, m, c, e = variables("p q h k l p0 m c e")  # noqa: E741


def over_an_edge(cut_left: int, cut_right: int, vertices: int) -> list[tuple[str, ...]]:
    """Return the faces between L R and the top t0 t1 .., phases 2 to 4, Lemma 3's as one."""
    faces: list[tuple[str, ...]] = [("L", f"t{i + 1}", f"t{i}") for i in range(cut_left)]
    last = vertices - 1 - cut_right
    faces += [("R", f"t{i + 1}", f"t{i}") for i in range(last, vertices - 1)]
    top = [f"t{i}" for i in range(cut_left, last + 1)]
    if len(top) == 2:
        around = ("L", "R", top[1], top[0])
    else:
        around = ("L", "R", "b'", "a'")
        faces += [("L", "a'", top[0]), ("R", top[-1], "b'"), (*top[::-1], "a'", "b'")]
    return faces + [(f, g, "s") for f, g in zip(around, (*around[1:], around[0]), strict=True)]


def assert_faces() -> None:
    """Assert what the directed sides of the faces over an edge, and of a fan, add up to."""
    for left, right, inner in product(range(LONGEST), range(LONGEST), range(LONGEST)):
        vertices = left + right + inner + 2
        top = [f"t{i}" for i in range(vertices)]
        assert boundary(over_an_edge(left, right, vertices)) == path("L", "R", *top[::-1], "L")
    for vertices in range(2, LONGEST):
        top = [f"t{i}" for i in range(vertices)]
        assert boundary(("v", g, f) for f, g in pairwise(top)) == path("v", *top[::-1], "v")


assert_faces()
STRUCTURE = [
    states("paper-tube-tiles.before", "t is still before R, and u after "
           "L", (at_least(l - mpq(1, 4), p0), at_least(p0 + m, p),
           at_least(mpq(1, 20), m)), more(l, p)),
    states("paper-tube-tiles.one-turns", "it cannot be that neither L, u, t nor R, u, t turns left",
           (more(h), more(k), more(q), more(l), more(l, p), more(q, p), at_least(k * p, q * h),
            at_least(k * (p - l), (q - l) * h)), None, Hint(degrees=(3, 4), cases=(at_least(p),))),
]
NOT_BELOW = (at_least(c, LEVELLED), at_least(1, c), at_least(TILT, e), at_least(e, -TILT),
             at_least(h, mpq(1, 5)), at_least(p, -mpq(3, 10)), at_least(e * p, c * h))
CUT = [
    states("paper-tube-tiles.cut-obtuse", "L on or above the line of T: the angle at t is "
           "obtuse", NOT_BELOW, more(c * p + e * h),
           Hint(degrees=(2, 3, 4), cases=(at_least(p),))),
    states("paper-tube-tiles.cut-wide", "and 135 degrees or "
           "more", NOT_BELOW, at_least((c * p + e * h)**2, (e * p - c * h)**2),
           Hint(degrees=(3, 4, 5), cases=(at_least(p),))),
]
TURNED = [
    states("paper-tube-tiles.low-left", "(a', L, s) turns left", LOW, more(BESIDE_LOW)),
    states("paper-tube-tiles.low-top", "(b', a', s) turns left", (*LOW, at_least(height, FLOOR)), more(GAP)),
    states("paper-tube-tiles.low-bottom", "(L, R, s) turns left, s being above "
           "B", (*LOW, more(LENGTH)), more(LENGTH * v)),
]
STATEMENTS = [*STRUCTURE, *CUT, *TURNED]



def known(theorems: list[Theorem], *claims: str) -> tuple[str, ...]:
    """Return the problems of the theorems that prove some claims."""
    return tuple(dict.fromkeys(p for t in theorems if t.claim in claims and t.shows == "claim" for p in t.problems))


PLANE = "P and P4 are disjoint simple polygons, one in the other: Lemma 2 for P and P3, 1/(4 sqrt 2) > 2 m apart. "
APART = (*known(REFINED, "section-2.p4-both-regions"), *LEMMA_2)
OWN = (*names(STRUCTURE, CUT, TURNED), *names(ANGLES[:1]), *TURNS)
FACES = (*OWN, *names(PROJECTION), *known(TALL, "phase-3.tall"),
         *known(TILINGS, "lemma-3.triangulation", "theorem-2.proper-rectangle"))
TILED = ("Directed sides of all faces over an edge or a chord add up to its boundary, as the script asserts, and "
         "spokes cancel: what is left are P and P4, cut at its vertices. ")
TURN = ("Faces turn left: fans, parts of triangles with an area, see `phase-1.snapped-angle`; cuts, as L is below the "
        "line of T where its angle is not wide; the triangles beside a rectangle and R, see `phase-2.projection`; "
        "faces at vertices of phase 3; the faces of a rectangle, moved and stretched without a reflection. ")
GROUP = "paper-tube-tiles"
THEOREMS = [
    Theorem("phase-1.structure", "claim", "edges of P with theirs of P4 and two spokes, and chords with their corners, "
            "turn left and tile the Tube", (*names(STRUCTURE), *names(ANGLES[:1]), *TURNS, *APART), PLANE + "Before "
            "snapping an edge of P4 is 1/2 long, or in triangles sqrt(3)/6, and begins 1/4 before L at most, in "
            "triangles not before it. Winding numbers of the parts add up to 1 in the Tube and 0 outside."),
    Theorem("tube.tiles", "claim", "the faces tile the "
            "Tube", tuple(dict.fromkeys((*FACES, *APART))), PLANE + TILED + TURN +
            "So winding numbers, 1 in a face, add up to 1 in the Tube."),
    Theorem("section-2.tube-keeps-boundary", "claim", "the boundary of the Tube's faces is P and P4 with the vertices "
            "of P5", tuple(dict.fromkeys((*FACES, *APART))), PLANE + TILED + TURN + "A vertex on the boundary would be "
            "in directed sides that are left."),
    Theorem("theorem-1.triangulation", "claim", "the mesh is a triangulation that leaves P whole, in the published and "
            "in the repaired construction", names(STRUCTURE), "Published: P5 is cut into P6, which meets the Tube "
            "along P4 with the vertices of P5. Repaired: the Interior and the Tube meet along Q; triangles stay as "
            "they are.",
            "", ("section-2.p5-tiles", "section-2.p6-tiles", "tube.tiles", "section-2.tube-keeps-boundary",
                 "repaired.interior-tiling", "repaired.tube-tiling")),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
