"""Check the paper's Tube as it is after snapping, phase by phase; `paper_tube.py` is not imported.

Values are squares of lengths in units of the mfs, or of sines. Bounds are handed in, because they depend on the reading
of d3. B is the edge of P below a quasi-trapz, T its top on P4, T' what phase 2 leaves of T, Q' lies between B and T',
Q'' between B and a' b'.

Structure   what phase 1 leaves, an edge of P and one of P4 with two spokes, or a chord with a corner of P, is simple
            and turns left: then all of it tiles the Tube.
Angles      a spoke, or a fan's edge, makes an angle of at least arcsin(1/4) with P4; an edge cut off in phase 2 one of
            at least 45 degrees with T.
Projection  R = a b b' a' lies in Q', and T' projects onto B at right angles to T'.
Feature     the faces of some phases, Q' or Q'' keep a feature size.
"""

from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared, face_witness
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.numbers.rational import sqrt_below
from exactmesh.planar.cycles import directed_edges
from exactmesh.steps import patch_check
from exactmesh.steps.records import Cycle, Offset, PaperTube, Patch, Phase, Rectangle, Shape, Trapezoidation

PHASES: tuple[Phase, ...] = ("fan", "cut", "rest", "tall", "low", "rectangle")
# An angle's squared sine; an obtuse angle counts as a right one.
_SNAPPED = mpq(1, 16)
_CUT = mpq(1, 2)


def check_tiling(shape: Shape, p4: Offset, chords: Trapezoidation, interior: Patch, tube: PaperTube,
                 points: Sequence[Point]) -> Verdict:
    """Return whether the faces tile what lies between P and P4 and leave its boundary as it is."""
    return patch_check.check_tube_tiling(shape, p4, chords, interior, tube.patch, points)


def check_structure(shape: Shape, p4: Offset, points: Sequence[Point]) -> Verdict:
    """Return whether phase 1 cuts the Tube into triangles and quasi-trapz; one instance an edge of P4."""
    following = p4.successors()
    for k, source in enumerate(p4.source):
        t, u = points[p4.first + k], points[p4.first + following[k]]
        corner = points[shape.origin[p4.corner[k]]]
        region = [corner, u, t] if source < 0 else [*_ends(shape, source, points), u, t]
        if not _turns_left(region):
            return failed(k + 1, "triangles and quasi-trapz are simple", edge_of_q=k, at=str(t))
    return Verdict(len(p4.source), True)


def check_snapped_angles(shape: Shape, p4: Offset, tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared sine of the angles between spokes, or edges of fans, and P4."""
    tally = Tally("the angle with P4 is at least arcsin(1/4)", ">=", _SNAPPED)
    following = p4.successors()
    for k, after in enumerate(following):
        for t, onward in ((k, after), (after, k)):
            corner, at = points[shape.origin[p4.corner[t]]], points[p4.first + t]
            tally.see(_sine_squared(at, corner, points[p4.first + onward]), vertex=p4.first + t, at=str(at))
    for face in _faces(tube, ("fan",)):
        for v, other in ((face[1], face[2]), (face[2], face[1])):
            tally.see(_sine_squared(points[v], points[face[0]], points[other]), vertex=v, at=str(points[v]))
    return tally.verdict()


def check_cut_angle(chords: Trapezoidation, tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared sine of the angles between new edges of phase 2 and T."""
    tally = Tally("the angle with T is at least 45 degrees", ">=", _CUT)
    for v, s, t in _faces(tube, ("cut",)):
        for end, other in ((s, t), (t, s)):
            if end >= chords.first:
                a, b = minus(points[v], points[end]), minus(points[other], points[end])
                tally.see(cross(a, b) ** 2 / (dot(a, a) * dot(b, b)), face=[v, s, t], at=str(points[end]))
    return tally.verdict()


def check_projection(shape: Shape, tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return whether R lies in Q' and T' projects onto B; one instance a rectangle."""
    for number, record in enumerate(tube.rectangles):
        left, right = _ends(shape, record.edge, points)
        b, a, a_below, b_below = (points[v] for v in (record.side[0], record.side[-1], record.a_below, record.b_below))
        if not (orientation(left, a_below, a) > 0 and orientation(right, b, b_below) > 0
                and _turns_left([left, right, b_below, a_below])):
            return failed(number + 1, "R lies in Q'", rectangle=number, edge=record.edge >> 1)
        along = minus(a, b)
        if any(dot(minus(end, p), along) * side > 0 for p in (a, b) for end, side in ((right, 1), (left, -1))):
            return failed(number + 1, "T' projects onto B", rectangle=number, edge=record.edge >> 1)
    return Verdict(len(tube.rectangles), True)


def check_upper(shape: Shape, tube: PaperTube, points: Sequence[Point], mfs_squared: mpq, bound_squared: mpq
                ) -> Verdict:
    """Return the verdict on the squared mfs of Q', with the vertices on T'; one instance a rectangle."""
    tally = Tally("mfs(Q') is the spacing", ">=", bound_squared)
    for number, record in enumerate(tube.rectangles):
        cycle = (*_edge(shape, record), *record.side)
        tally.see(face_witness(points, cycle).squared / mfs_squared, rectangle=number, edge=record.edge >> 1)
    return tally.verdict()


def check_lower(shape: Shape, tube: PaperTube, points: Sequence[Point], mfs_squared: mpq, bound_squared: mpq
                ) -> Verdict:
    """Return the verdict on the squared mfs of Q''; one instance a rectangle."""
    tally = Tally("mfs(Q'') is half the spacing", ">=", bound_squared)
    for number, record in enumerate(tube.rectangles):
        cycle = (*_edge(shape, record), record.b_below, record.a_below)
        tally.see(face_witness(points, cycle).squared / mfs_squared, rectangle=number, edge=record.edge >> 1)
    return tally.verdict()


def check_feature(tube: PaperTube, points: Sequence[Point], mfs_squared: mpq, tally: Tally,
                  phases: Collection[Phase] = PHASES) -> Verdict:
    """Return the verdict on the squared feature size of the faces of some phases; `tally` has the bound."""
    for face in _faces(tube, phases):
        tally.see(_feature(points, face) / mfs_squared, face=list(face), at=str(points[face[-1]]))
    return tally.verdict()


def check_low_vertex(shape: Shape, p4: Offset, tube: PaperTube, points: Sequence[Point], mfs_squared: mpq,
                     bound_squared: mpq) -> Verdict:
    """Return the verdict on the squared feature size that phase 3 to the letter would leave in the quasi-trapz between
    P and P4: with one vertex over Lemma 1's abscissa, at a quarter of the spacing from B, less a millionth."""
    tally = Tally("the vertex at 1/(8 d3) keeps 1/(8 d3)", ">=", bound_squared)
    for source, (left, right, top_right, top_left) in _tall(shape, p4, tube):
        p, q, u, t = (points[v] for v in (left, right, top_right, top_left))
        base, length_squared = minus(q, p), distance_squared(p, q)
        at_left, at_right = (dot(minus(end, p), base) / length_squared for end in (t, u))
        up = sqrt_below((p4.spacing / 4) ** 2 / length_squared, 24)
        x = _lemma_1_abscissa((mpq(0), mpq(1)), (at_left, at_right))
        s = Point(p.x + x * base.x - up * base.y, p.y + x * base.y + up * base.x)
        fan = (p, q, u, t, s)
        least = min(_feature(fan, (i, (i + 1) % 4, 4)) for i in range(4))
        tally.see(least / mfs_squared, edge=source >> 1, at=str(s))
    return tally.verdict()


def check_gaps(tube: PaperTube, points: Sequence[Point], mfs_squared: mpq, bound_squared: mpq) -> Verdict:
    """Return the verdict on the least squared distance of neighbours on the tops of rectangles; one instance a pair."""
    tally = Tally("neighbours are the spacing apart", ">=", bound_squared)
    for number, record in enumerate(tube.rectangles):
        for u, v in pairwise(record.side):
            tally.see(distance_squared(points[u], points[v]) / mfs_squared, rectangle=number, vertices=[u, v])
    return tally.verdict()


def check_longer_side(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared ratio of |a b| to |a a'|; one instance a rectangle."""
    tally = Tally("|a b| >= |a a'|", ">=", mpq(1))
    for number, record in enumerate(tube.rectangles):
        a = points[record.side[-1]]
        tally.see(distance_squared(a, points[record.side[0]]) / distance_squared(a, points[record.a_below]),
                  rectangle=number, edge=record.edge >> 1)
    return tally.verdict()


def check_steiner_count(vertices: int, corners: int) -> Verdict:
    """Return the verdict on the number of Steiner vertices a corner of P, given all vertices of the mesh."""
    tally = Tally("at most 36 Steiner vertices a corner", "<=", mpq(36))
    tally.see(mpq(vertices - corners, corners), steiner=vertices - corners, corners=corners)
    return tally.verdict()


def check_proper_elsewhere(interior: Patch, tube: PaperTube, apart: Collection[Phase]) -> Verdict:
    """Return whether all faces but those of some phases have three vertices; one instance a face."""
    faces = [*interior.faces, *_faces(tube, set(PHASES) - set(apart))]
    for number, face in enumerate(faces):
        if len(face) != 3:
            return failed(number + 1, "faces have three vertices", face=list(face))
    return Verdict(len(faces), True)


def _tall(shape: Shape, p4: Offset, tube: PaperTube) -> Iterator[tuple[int, Cycle]]:
    """Yield the quasi-trapz between P and P4 that got a vertex of phase 3, by half-edge, counter-clockwise from B."""
    faces = list(_faces(tube, ("tall",)))
    owner, _ = directed_edges(faces)
    for source in p4.source:
        side = shape.origin[source], shape.origin[source ^ 1]
        if source >= 0 and side in owner:
            left, right = side
            (s,) = set(faces[owner[side]]).difference(side)
            (top_right,) = set(faces[owner[s, right]]).difference((s, right))
            (top_left,) = set(faces[owner[left, s]]).difference((s, left))
            yield source, (left, right, top_right, top_left)


def _lemma_1_abscissa(low: tuple[mpq, mpq], high: tuple[mpq, mpq]) -> mpq:
    """Return the abscissa of the centre of Lemma 1's rectangle or parallelogram between two parallel sides."""
    short, long = (high, low) if high[1] - high[0] < low[1] - low[0] else (low, high)
    width = short[1] - short[0]
    start = min(max(short[0], long[0]), long[1] - width)
    return (short[0] + start + width) / 2


def _sine_squared(at: Point, p: Point, q: Point) -> mpq:
    """Return the squared sine of the angle p, at, q; an obtuse angle counts as a right one."""
    a, b = minus(p, at), minus(q, at)
    return mpq(1) if dot(a, b) <= 0 else cross(a, b) ** 2 / (dot(a, a) * dot(b, b))


def _turns_left(corners: Sequence[Point]) -> bool:
    """Return whether a triangle, or a quadrilateral cut by one of its diagonals, is simple and counter-clockwise."""
    if len(corners) == 3:
        return orientation(*corners) > 0
    p, q, r, s = corners
    return (orientation(p, q, r) > 0 and orientation(p, r, s) > 0) or (
        orientation(q, r, s) > 0 and orientation(q, s, p) > 0)


def _faces(tube: PaperTube, phases: Collection[str]) -> Iterator[Cycle]:
    return (face for face, phase in zip(tube.patch.faces, tube.phase, strict=True) if phase in phases)


def _edge(shape: Shape, record: Rectangle) -> tuple[int, int]:
    return shape.origin[record.edge], shape.origin[record.edge ^ 1]


def _ends(shape: Shape, half_edge: int, points: Sequence[Point]) -> tuple[Point, Point]:
    return points[shape.origin[half_edge]], points[shape.origin[half_edge ^ 1]]


def _feature(points: Sequence[Point], face: Cycle) -> mpq:
    """Return the squared feature size of a face, zero for what is no triangle."""
    corners = corners_of(points, face)
    return mpq(0) if isinstance(corners, NotTriangle) else face_feature_squared(points, face, corners)
