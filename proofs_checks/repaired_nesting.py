"""Prove I3 of the repaired construction: Q is simple, on levels, turned like P and inside its face.

Given   mfs 1 (m <= mfs), or ifs 1 for internal meshes. The motion: K1 grows from a point to its size, then all vertices
        of Q go straight to their levels, all the while evenly. A corner (e0, e1) at p has a wedge W, the directions
        from e1 counter-clockwise to e0; its vertices of Q are a run of p + k, or one p + k with k extreme for both
        edges, or the crossing of the offset edges. Ring and walk correspond, and vertices are on levels, as they are
        made so.
Claim   At every moment, no vertex of Q or P is on an edge of Q or P that does not end there, but for those of P alone.
        wedge: q is g or more from what is not in W, as n.(q - p) >= g for a normal n between those of e0 and e1.
        line: e' is g or more from e, if both ends are from its line.
        beyond: a ray from p beyond the end of an edge at p is 1 or more from another edge at p.
        path: e0' is on the line n0.x = h, where the other edge of a reflex corner is not.
        rib: the points w + t k of e', w on e, have been in it from the beginning on.
Method  Every pair has one label (`LABELS`), found by program from which ends are the same vertices (`pairs`); that
        there are no other kinds of corner is checked by making one of each (`corner_kinds`).
Tight   g: a level edge and a snap of half a level. While K1 is t times its size, read t g and t 0.15.
By hand that edges which come to cross first have an end of one on the other; the beginning of the motion; that what
        is true of K1 is true of t K1.
"""

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise, product

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, dot, equal, main, more, spot, square, states
from repaired_caps import OCTAGON
from repaired_caps import STATEMENTS as CAPS
from repaired_offset import REACH, THICK, names
from repaired_separation import STATEMENTS as SEPARATION

from exactmesh.geometry.point import Point
from exactmesh.geometry.point import cross as cross_of
from exactmesh.geometry.point import dot as dot_of
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import LEVEL
from exactmesh.steps.offset import offset
from exactmesh.steps.records import Shape

a, b, c, h, k, m, s, t, w, L, nx, ny, x, y = variables("a b c h k m s t w L nx ny x y")
normal, off = spot(nx, ny), spot(x, y)

# Kinds of corner, by the sources of their vertices of Q.
CAP, SHARED, CROSSING = "cap", "shared", "crossing"
K1 = [Point(*(mpq(str(value)) for value in k)) for k in OCTAGON]


def directions() -> list[Point]:
    """Return an edge of each of the 16 classes of normals, three where the class is an open angle.

    The classes are symmetric about the origin: so two edges of different, not opposite ones turn one way only, and
    three in each angle, with their opposites, turn every way there is.
    """
    edges = [Point(q.x - p.x, q.y - p.y) for p, q in zip(K1, (*K1[1:], K1[0]), strict=True)]
    between = [Point(i * p.x + j * q.x, i * p.y + j * q.y)
               for p, q in zip((edges[-1], *edges[:-1]), edges, strict=True) for i, j in ((2, 1), (1, 1), (1, 2))]
    # An edge of the body has its inside on the left; an edge of P with the same outer normal runs the other way.
    return [Point(-d.x, -d.y) for d in (*edges, *between)]


def extreme(d: Point) -> list[int]:
    """Return the vertices of K1 farthest along (-dy, dx)."""
    values = [cross_of(d, k) for k in K1]
    return [i for i, value in enumerate(values) if value == max(values)]


def vertices_at(d0: Point, d1: Point) -> list[Point]:
    """Return what the offset has at a corner at the origin, half a level off: snapping moves it by 0."""
    before, zero, after = Point(-d0.x, -d0.y), Point(mpq(0), mpq(0)), d1
    points = [before, zero, after]
    origin: tuple[int, ...] = (0, 1, 1, 2, 2, 0)
    walk: tuple[int, ...] = (0, 2, 4)
    if before == after:
        points, origin, walk = points[:2], (0, 1), (0, 1)
    made = offset(Shape(mpq(1), tuple(points), origin, ((walk,),), ((),), ()))
    return [q for q, corner in zip(made.points, made.corner, strict=True) if corner == walk[1]]


def corner_kinds() -> Counter[tuple[str, int]]:
    """Return how often each kind of corner comes up, with its number of vertices; raises `AssertionError` for one that
    is not as the docstring says."""
    seen: Counter[tuple[str, int]] = Counter()
    for d0, d1 in product(directions(), repeat=2):
        turn, ahead = cross_of(d0, d1), dot_of(d0, d1)
        made = vertices_at(d0, d1)
        places = [K1.index(q) if q in K1 else -1 for q in made]
        reflex = turn < 0 or (turn == 0 and ahead < 0)
        if set(extreme(d0)) & set(extreme(d1)):
            assert len(places) == 1 and places[0] in extreme(d0) and places[0] in extreme(d1)
            assert ahead > 0 or turn, "a slit end has a run"
            kind = SHARED
        elif reflex:
            assert places[0] in extreme(d0) and places[-1] in extreme(d1) and 2 <= len(places) <= 5
            n0, n1 = Point(-d0.y, d0.x), Point(-d1.y, d1.x)
            for i, j in pairwise(places):
                assert j == (i - 1) % 8
                outward = Point(K1[i].y - K1[j].y, K1[j].x - K1[i].x)
                # A normal of both, clockwise between those of the two edges.
                assert cross_of(outward, n0) >= 0 and cross_of(n1, outward) >= 0
            kind = CAP
        else:
            assert turn > 0 and len(made) == 1
            kind = CROSSING
        seen[kind, len(made)] += 1
    return seen


# The ends of the edges of a corner are a, p and p, b; at a slit end b is a. x and y are any other vertices.
VERTICES = "pabxy"
EDGES = tuple((u, v) for u in VERTICES for v in VERTICES if u != v)
LABELS = {
    "apart": "parts of P without a common vertex, one for q and one for the edge: they are 1 apart",
    "triangle": "the edge closes the triangle of a convex corner",
    "caps": "the cap and the offset edge at its own end",
    "octagon": "a vertex and an edge of one cap",
    "wedge": "q, or an edge of a cap, and what is not in its wedge",
    "line": "an offset edge and the ends of its edge",
}


def pairs() -> Iterator[tuple[str, tuple[object, ...]]]:
    """Yield every pair of a vertex and an edge that it does not end, one of them or both of Q, with its label.

    A pair is named by kind of corner, what the other is, and the vertices of P that it belongs to. Of an isolated
    vertex nothing is a or b.
    """
    for kind, slit in ((CAP, False), (CAP, True), (SHARED, False), (CROSSING, False)):
        def same(v: str, slit: bool = slit) -> str:
            return "a" if slit and v == "b" else v
        edges = {(same(u), same(v)) for u, v in EDGES if same(u) != same(v)}
        own = {("a", "p"): "e0", ("p", same("b")): "e1"}
        sources = [{"a", "p"}, {"p", "b"}] if kind == CROSSING else [{"p"}]
        for edge in sorted(edges):
            apart = any(not part & set(edge) for part in sources)
            if edge not in own or kind == CAP:
                yield ("apart" if apart else "triangle" if "p" not in edge else "caps" if edge in own else "wedge",
                       (kind, slit, "offset edge", edge))
            yield ("apart" if apart else "triangle" if "p" not in edge else "wedge",
                   (kind, slit, "edge of P", edge))
        for v in sorted({same(v) for v in VERTICES}):
            apart = any(v not in part for part in sources)
            yield "wedge" if v == "p" else "apart" if apart else "", (kind, slit, "cap of another corner", v)
        if kind == CAP:
            yield "octagon", (kind, slit, "own cap", "p")
    for edge, v in product(EDGES, VERTICES):
        yield "line" if v in edge else "apart", ("vertex of P", False, "offset edge", (*edge, v))
    for v in VERTICES:
        yield "wedge" if v == "p" else "apart", ("vertex of P", False, "cap", v)


KINDS = corner_kinds()
assert set(KINDS) == {(CAP, 2), (CAP, 3), (CAP, 4), (CAP, 5), (SHARED, 1), (CROSSING, 1)}, KINDS
PAIRS = Counter(label for label, _ in pairs())
assert set(PAIRS) == set(LABELS), PAIRS

STATEMENTS = [
    bounded("nesting.wedge", "n.x >= g and n.c <= 0 for |n| = 1: x and c are g apart, (x, y) being from c to x",
            (equal(nx * nx + ny * ny, 1), at_least(dot(normal, off), LEVEL)),
            lambda f: at_least(dot(off, off), square(f) * LEVEL**2),
            Hint(degrees=(2, 3, 4), squares=(nx * y - ny * x, nx, ny, x, y)), {"nx": "1", "ny": "0", "x": "29/125",
                                                                             "y": "0"}),
    bounded("nesting.line", "both ends of e' are g from the line: so is all of it",
            (at_least(a, LEVEL), at_least(b, LEVEL), at_least(t), at_least(1, t)),
            lambda f: at_least(a + t * (b - a), LEVEL * mpq(f)), Hint(degrees=(2,))),
    bounded("nesting.beyond", "p + L v, L >= 1, is L times as far from p + w as v is from w/L, which is on the edge",
            (at_least(L, 1), at_least(x * x + y * y, 1)),
            lambda f: at_least(L * L * (x * x + y * y), square(f)), Hint(degrees=(4,), squares=(x, y))),
    states("nesting.path", "n0.k1 < h and n0.d1 <= 0 for a cap: n0 on e1' stays below h",
           (more(h, m), at_least(s), at_least(0, c)), more(h, m + s * c)),
    states("nesting.rib", "w >= 0 beyond p along e, e' begins at t x: if w + t k is after that, so is w + s k at s x",
           (at_least(w), more(t), at_least(w + t * k, t * x), at_least(s), at_least(t, s)),
           at_least(w + s * k, s * x), Hint(degrees=(2, 3))),
]

ARGUMENT = (
    "At every moment a vertex in p + k is in p + K2, a crossing in e0 + K2 and in e1 + K2, e' in e + K2, by "
    "`repaired.offset-separation`, so sources 1 apart stay apart, and from P as well. e' keeps the direction of e "
    "until it is snapped, as its ends never meet: the next edge has the one and not the other. "
    "`wedge` for an offset edge f = e2', e2 another edge at p or the other side of e0 or e1: its end at p is in "
    "another wedge. It does not cross e0 or e1, being apart from P, nor what is beyond them (`beyond`): so it is not "
    "in W. Thus no vertex meets an edge; edges that come to meet or to overlap, in rings of three vertices or more, "
    "would first do so at an end; so P and Q stay a plane graph if they begin as one. "
    "Soon after the beginning: what is of parts of P apart is apart. Two edges at p with an angle between are apart "
    "but near p; there corners have wedges of their own; in one, e0', the cap and e1' are a path that does not meet "
    "itself (`path`, or two rays from one point); the two sides of an edge are on either side of it. So Q is simple "
    "and in its face. A ring's area is nearly its walk's, or that is 0: then the walk is about a tree, or a vertex, "
    "and the ring goes clockwise around it. A simple ring keeps its turn. "
    "Internal meshes: measured along paths in the closed face, features without a common vertex are 1 apart, as a "
    "shortest path is straight, or bends at a vertex 1 from a feature. Until Q first meets P, e' has come by ribs "
    "w + t k from w on e (`rib`), caps from p, and then straight up or down, all in the face; the triangle of such a "
    "way has no vertex in it, less than 1 from where it began; so there is a straight one, of 0.4701 at most, and what "
    "meets has sources with a common vertex. w does not pass the far end of e0, which would be 0.85 from e1. If e2' "
    "crossed what is beyond e1, the parallel to the rib there through the first vertex towards p would join that "
    "vertex to e2. In a triangle the lowest vertex over a side sees it.")
GROUP = "nesting"
NAMES = tuple(statement.id for statement in (*STATEMENTS, *SEPARATION, *CAPS))
THEOREMS = [Theorem(
    "repaired.offset-nesting", "claim", "Q is simple, on levels, turned like P and inside its face",
    (*NAMES, *names([*THICK, *REACH]), "offset.separation", "offset.reaches"), ARGUMENT,
    "by program: 1024 corners, of six kinds, and all pairs of a vertex and an edge")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
