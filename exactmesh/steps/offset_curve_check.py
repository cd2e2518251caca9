"""Check the paper's P2 and P3 from their definition; `offset_curve.py` is not imported, nothing is rounded.

P2  the locus of the points inside P at distance mfs/4: a straight segment an edge, an arc a reflex corner.
P3  arcs over 90 degrees give way to two chords through their middle, arcs under 90 degrees to the prolonged segments;
    at 90 degrees, which the paper leaves open, either will do.

Lengths are in units of the mfs, so the values of verdicts are squares of length/mfs. A check of distances first looks
at pairs that floats cannot rule out (`measure.algebraic_mfs`).

Why clauses on corners and segments settle that P2 is the whole locus: the points of an edge's parallel at distance
mfs/4 that are no nearer to another feature of P form one segment, since features without a common vertex are mfs apart
or more; the clauses place its two ends, and between edges only the arcs about reflex corners are left.
"""

from collections.abc import Sequence
from itertools import chain

from gmpy2 import mpq

from exactmesh.geometry.point import Point, dot
from exactmesh.measure.algebraic_mfs import Labelled, Least, Place, algebraic_mfs, least_between, real_place
from exactmesh.measure.verdict import Relation, Tally, Verdict, Witness, failed
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.planar.pslg import Edge
from exactmesh.steps.curve_view import Corner, Polygons, Straight, decimal_place, p3_of, rings_of, straights_of
from exactmesh.steps.reading import sin_eighth
from exactmesh.steps.records import OffsetCurve, RealPoint, Shape

_QUARTER_SQUARED = mpq(1, 16)
# No vertex of P has this number: pairs of P and P3 are compared however they are labelled.
_NONE = -1


def check_single_curve(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return whether P2 is one closed curve a walk, and the least squared distance of its segments from edges and
    vertices of P that they do not belong to; one instance a segment."""
    rings = rings_of(shape, curve)
    straights = straights_of(rings)
    walks = [walk for walks in shape.faces for walk in walks]
    if [tuple(c.corner for c in ring) for ring in curve.rings] != walks:
        return failed(len(straights), "P2 has the corners of P in their order")
    for corner in chain.from_iterable(rings):
        if (clause := _broken_in_p2(corner, curve.mfs_squared)) is not None:
            return failed(len(straights), clause, vertex=corner.vertex, at=str(corner.p))
    for number, straight in enumerate(straights):
        if straight.length_squared().sign() <= 0:
            return failed(number + 1, "a segment runs along its edge", edge=_edge(straight))
    places = [real_place(p) for p in shape.points] + [end for s in straights for end in (s.start, s.end)]
    count = len(shape.points)
    ends = [(count + 2 * i, count + 2 * i + 1) for i in range(len(straights))]
    own = [_edge(s) for s in straights]
    least = least_between(places, [
        Labelled(range(count), range(count), ends, own),
        Labelled(range(count, len(places)), [v for edge in own for v in edge], own, own)],
        ">=", _QUARTER_SQUARED * curve.mfs_squared)
    return _verdict(len(straights), "nothing else of P is nearer than mfs/4", least, places, curve)


def check_arcs(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the cosines of the spans of arcs: above -1, and clockwise; one instance an arc."""
    tally = Tally("an arc spans less than 180 degrees", ">", mpq(-1))
    for corner in chain.from_iterable(rings_of(shape, curve)):
        if corner.record.arc is None:
            continue
        a, b = (_from(corner.p, end) for end in corner.record.arc)
        if _cross(a, b).sign() >= 0:
            return failed(tally.instances + 1, tally.clause, vertex=corner.vertex, at=str(corner.p))
        tally.see(16 * _dot(a, b) / curve.mfs_squared, vertex=corner.vertex, at=str(corner.p))
    return tally.verdict()


def check_refinement(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return whether P3 replaces the arcs of P2 as the paper says; one instance a corner."""
    corners = list(chain.from_iterable(rings_of(shape, curve)))
    for number, corner in enumerate(corners):
        if (clause := _broken_in_p3(corner, curve.mfs_squared)) is not None:
            return failed(number + 1, clause, vertex=corner.vertex, at=str(corner.p))
    return Verdict(len(corners), True)


def check_tube_distance(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the least squared distance between P and P3; one instance a vertex of P3."""
    p3 = p3_of(rings_of(shape, curve))
    return _distance_from_p(shape, curve, p3, ">=", mpq(1, 32), "P3 keeps 1/(4 sqrt 2) from P")


def check_octagon(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on squared chords of arcs of 90 degrees against the side of a regular octagon of diameter
    mfs/4, which is sin(pi/8)/4 mfs; one instance a chord."""
    tally = Tally("a chord is as long as the octagon's side", "==", (sin_eighth() / 4) ** 2)
    for corner in chain.from_iterable(rings_of(shape, curve)):
        if len(corner.record.vertices) == 3 and dot(corner.before, corner.after) == 0:
            a, m, b = (_from(corner.p, v) for v in corner.record.vertices)
            for end in (a, b):
                chord = RealPoint(end.x - m.x, end.y - m.y)
                tally.see(_dot(chord, chord) / curve.mfs_squared, vertex=corner.vertex, at=str(corner.p))
    return tally.verdict()


def check_feature_size(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the squared minimum feature size of P3; one instance a vertex of P3."""
    p3 = p3_of(rings_of(shape, curve))
    bound = (sin_eighth() / 2) ** 2
    least = algebraic_mfs(p3.places, p3.edges, ">=", bound * curve.mfs_squared)
    return _verdict(len(p3.places), "mfs(P3) >= sin(pi/8)/2", least, p3.places, curve)


def check_separation(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on squared distances in P3 between a vertex and an edge that do not share a corner of P,
    against 1 - sqrt(2)/2; one instance a vertex of P3."""
    return _separation(shape, curve, (1 - sqrt(2) / 2) ** 2, "1 - sqrt(2)/2 apart")


def check_through_interior(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the same distances against 1/2; one instance a vertex of P3."""
    return _separation(shape, curve, mpq(1, 4), "1/2 apart")


def check_extension_from_p(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the least squared distance from P of the vertices where prolonged segments meet, and of
    the prolonged parts from what does not belong to their corner; one instance such a vertex."""
    prolonged = [c for ring in rings_of(shape, curve) for c in ring if c.record.kind == "prolonged" and c.record.arc]
    places = [real_place(p) for p in shape.points]
    count = len(places)
    edges = _edges_of(shape)
    groups = []
    for corner in prolonged:
        tip = len(places)
        places += [corner.record.vertices[0], *(corner.record.arc or ())]
        parts = [(tip, tip + 1), (tip, tip + 2)]
        groups += [
            Labelled([tip], [_NONE], edges, edges),
            Labelled([tip + 1, tip + 2], [corner.vertex] * 2, edges, edges),
            Labelled(range(count), range(count), parts, [(corner.vertex, corner.vertex)] * 2)]
    least = least_between(places, groups, ">", _QUARTER_SQUARED * curve.mfs_squared)
    return _verdict(len(prolonged), "a prolonged segment stays beyond mfs/4", least, places, curve)


def check_extension_from_vertex(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on squared distances of prolonged segments' meeting points from their corners."""
    tally = Tally("a prolonged segment stays within sqrt(2)/4 of its corner", "<=", mpq(1, 8))
    for corner in chain.from_iterable(rings_of(shape, curve)):
        if corner.record.kind == "prolonged":
            tip = _from(corner.p, corner.record.vertices[0])
            tally.see(_dot(tip, tip) / curve.mfs_squared, vertex=corner.vertex, at=str(corner.p))
    return tally.verdict()


def _separation(shape: Shape, curve: OffsetCurve, bound: mpq | Real, clause: str) -> Verdict:
    p3 = p3_of(rings_of(shape, curve))
    group = Labelled(range(len(p3.places)), p3.labels, p3.edges, p3.edge_labels)
    least = least_between(p3.places, [group], ">=", bound * curve.mfs_squared)
    return _verdict(len(p3.places), clause, least, p3.places, curve)


def _distance_from_p(shape: Shape, curve: OffsetCurve, p3: Polygons, relation: Relation, bound: mpq, clause: str
                     ) -> Verdict:
    places = [real_place(p) for p in shape.points] + list(p3.places)
    count = len(shape.points)
    p_edges = _edges_of(shape)
    q_edges = [(u + count, v + count) for u, v in p3.edges]
    least = least_between(places, [
        Labelled(range(count), [_NONE] * count, q_edges, q_edges),
        Labelled(range(count, len(places)), [_NONE] * len(p3.places), p_edges, p_edges)],
        relation, bound * curve.mfs_squared)
    return _verdict(len(p3.places), clause, least, places, curve)


def _verdict(instances: int, clause: str, least: Least | None, places: Sequence[Place], curve: OffsetCurve) -> Verdict:
    if least is None:
        return Verdict(instances, True)
    place = {"from": decimal_place(places[least.vertex]), "to": [decimal_place(places[v]) for v in least.edge]}
    return Verdict(instances, least.holds, least.squared / curve.mfs_squared, Witness(clause, place))


def _broken_in_p2(corner: Corner, mfs_squared: mpq) -> str | None:
    """Return the clause of the definition of P2 that a corner breaks."""
    if (corner.record.arc is not None) != corner.is_reflex:
        return "arcs are at the reflex corners"
    last, first = (_from(corner.p, end) for end in corner.ends)
    on_both = _is_parallel(corner.before, last, mfs_squared) and _is_parallel(corner.after, first, mfs_squared)
    if not on_both:
        return "a segment is mfs/4 inside its edge"
    if not corner.is_reflex and last != first:
        return "segments meet at a corner without an arc"
    if (corner.is_reflex or corner.is_flat) and (_dot(corner.before, last) or _dot(corner.after, first)):
        return "an arc goes from one perpendicular to the other"
    return None


def _broken_in_p3(corner: Corner, mfs_squared: mpq) -> str | None:
    """Return the clause of the construction of P3 that a corner breaks."""
    vertices = [_from(corner.p, vertex) for vertex in corner.record.vertices]
    arc = corner.record.arc
    kind = corner.record.kind
    if arc is None:
        return None if len(vertices) == 1 and not corner.is_reflex else "a corner without an arc stays as it is"
    # The edges of P turn by as much as the arc spans.
    ahead = dot(corner.before, corner.after)
    if kind != ("chords" if ahead < 0 else "prolonged") and (ahead or kind not in ("chords", "prolonged")):
        return "arcs over 90 degrees become chords, arcs under 90 degrees are prolonged"
    if kind == "prolonged":
        meets = len(vertices) == 1 and all(_is_parallel(edge, vertices[0], mfs_squared)
                                           for edge in (corner.before, corner.after))
        return None if meets else "prolonged segments meet in one vertex"
    if len(vertices) != 3 or (corner.record.vertices[0], corner.record.vertices[2]) != arc:
        return "chords go from one end of the arc to the other"
    a, m, b = vertices
    is_middle = (16 * _dot(m, m) == mfs_squared and _dot(m, a) == _dot(m, b)
                 and _cross(a, m).sign() < 0 and _cross(m, b).sign() < 0)
    return None if is_middle else "two chords meet in the middle of the arc"


def _is_parallel(edge: Point, place: RealPoint, mfs_squared: mpq) -> bool:
    """Return whether a place, seen from an end of the edge, lies on the edge's inner parallel at distance mfs/4."""
    area = edge.x * place.y - edge.y * place.x
    return bool(area.sign() > 0 and 16 * area * area == mfs_squared * dot(edge, edge))


def _from(p: Point, place: RealPoint) -> RealPoint:
    return RealPoint(place.x - p.x, place.y - p.y)


def _dot(a: Point | RealPoint, b: RealPoint) -> Real:
    return a.x * b.x + a.y * b.y


def _cross(a: RealPoint, b: RealPoint) -> Real:
    return a.x * b.y - a.y * b.x


def _edge(straight: Straight) -> Edge:
    return straight.first.vertex, straight.last.vertex


def _edges_of(shape: Shape) -> list[Edge]:
    """Return the edges of P on the walks, each once."""
    return [(shape.origin[h], shape.origin[h ^ 1]) for walks in shape.faces for walk in walks for h in walk]
