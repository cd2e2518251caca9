"""Check what Appendix A says of the straight segments e' of P2, edge by edge; `offset_curve.py` is not imported.

Letters are those of the paper: e runs from p1 to p2, u is the edge before it, w the angle at p1, e' from t1 to t2.
With e laid horizontally and P below it, y is the point of u at depth mfs, z lies above y on e, and J_y is the open
quarter of a disc of radius mfs about y on the side of e and p2. What is said of p1 is checked at p2 as well, mirrored.

Values are in units of the mfs: squares of lengths, or numbers where a docstring says so.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.measure.verdict import Tally, Verdict
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.steps.curve_view import Corner, Straight, rings_of, straights_of
from exactmesh.steps.records import OffsetCurve, RealPoint, Shape


def check_edge_length(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on |e'| >= 1/2; one instance an edge. A segment against its edge counts as negative."""
    tally = Tally("|e'| >= 1/2", ">=", mpq(1, 4))
    for s in _straights(shape, curve):
        _see(tally, s, s.length_squared() / curve.mfs_squared)
    return tally.verdict()


def check_both_reflex(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on |e'| = |e| where both corners are reflex; the value is |e'|/|e| squared."""
    tally = Tally("|e'| = |e|", "==", mpq(1))
    for s in _straights(shape, curve):
        if s.first.is_reflex and s.last.is_reflex:
            _see(tally, s, s.length_squared() / dot(s.edge, s.edge))
    return tally.verdict()


def check_one_reflex(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on |e'| > 1/2 where just one corner is reflex."""
    tally = Tally("|e'| > 1/2", ">", mpq(1, 4))
    for s in _straights(shape, curve):
        if s.first.is_reflex != s.last.is_reflex:
            _see(tally, s, s.length_squared() / curve.mfs_squared)
    return tally.verdict()


def check_unit_edges(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on the cosines of both angles, numbers, at edges of length mfs between convex corners."""
    tally = Tally("both angles are at least 90 degrees", "<=", mpq(0))
    for s in _convex(shape, curve):
        if dot(s.edge, s.edge) == curve.mfs_squared:
            for corner in (s.first, s.last):
                _see(tally, s, _cosine(corner))
    return tally.verdict()


def check_both_acute(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on |e'| > 1 where both angles are below 90 degrees."""
    tally = Tally("|e'| > 1", ">", mpq(1))
    for s in _straights(shape, curve):
        if s.first.is_acute and s.last.is_acute:
            _see(tally, s, s.length_squared() / curve.mfs_squared)
    return tally.verdict()


def check_reach(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on how far t1 lies beyond z, a number, for each angle below 90 degrees."""
    tally = Tally("t1 is at most 1/4 beyond z", "<=", mpq(1, 4))
    for end in _acute_ends(shape, curve):
        beyond = end.t.x * end.along.x + end.t.y * end.along.y - end.z * end.scale
        _see(tally, end.straight, beyond / end.scale)
    return tally.verdict()


def check_quarter_circle(shape: Shape, curve: OffsetCurve, only_next: bool = False) -> Verdict:
    """Return the verdict on squared distances from y, within the square about J_y, of all edges of P but e and u: 1 or
    more when J_y is free of them. One instance an edge that enters the square; both corners of e are convex.
    With `only_next`, of the edge that follows e at p2 alone."""
    tally = Tally("the edge after e misses J_y" if only_next else "no other edge of P meets J_y", ">=", mpq(1))
    edges = {h: (shape.points[shape.origin[h]], shape.points[shape.origin[h ^ 1]])
             for walks in shape.faces for walk in walks for h in walk}
    for end in _acute_ends(shape, curve):
        if end.other.is_reflex:
            continue
        for h in [end.next] if only_next else [h for h in edges if h not in (end.own, end.before)]:
            a, b = edges[h]
            near = _nearest_in_square(end, minus(a, end.corner.p), minus(b, end.corner.p))
            if near is not None:
                tally.see(near / (end.scale * end.scale), e=[end.corner.vertex, end.other.vertex],
                          edge=[shape.origin[h], shape.origin[h ^ 1]])
    return tally.verdict()


def check_sine(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on |e'| sin w = 1, squared, where w < 90 degrees and p2 is at distance mfs from u."""
    tally = Tally("sin w = 1/|e'|", "==", mpq(1))
    for end in _acute_ends(shape, curve):
        edge_squared = dot(end.along, end.along)
        if not end.other.is_reflex and end.sine_squared * edge_squared == curve.mfs_squared:
            _see(tally, end.straight, end.straight.length_squared() * end.sine_squared / curve.mfs_squared)
    return tally.verdict()


def check_formula(shape: Shape, curve: OffsetCurve) -> Verdict:
    """Return the verdict on 2 |e'| sin w >= 1, squared, where w < 90 degrees and the other corner is convex and not
    acute, in polygons with at least four corners. With equality where u and the edge after e are parallel and mfs
    apart: there |e'| = e'_1 + e'_2 as the paper computes it."""
    tally = Tally("|e'| >= 1/(2 sin w)", ">=", mpq(1))
    if len(curve.rings[0]) > 3:
        for end in _acute_ends(shape, curve):
            if not end.other.is_reflex and not end.other.is_acute:
                _see(tally, end.straight, 4 * end.straight.length_squared() * end.sine_squared / curve.mfs_squared)
    return tally.verdict()


@dataclass(frozen=True, slots=True)
class _AcuteEnd:
    """An end of e with an angle below 90 degrees: `corner` is p1, `other` p2, `along` the vector from p1 to p2; `own`,
    `before` and `next` are the half-edges of e, of u and of the edge beyond p2.

    Coordinates have their origin in p1; abscissae are dot products with `along`, depths cross products with e. Both
    are |e| times as long as they should be, so that y is at depth `scale` and abscissa `z` * `scale`.
    """

    straight: Straight
    corner: Corner
    other: Corner
    along: Point
    t: RealPoint
    z: mpq
    scale: Real
    sine_squared: mpq
    own: int
    before: int
    next: int

    def depth(self, place: Point) -> mpq:
        """Return the depth of a place below e."""
        return cross(self.straight.edge, place)

    def is_beside(self, a: Point, b: Point) -> bool:
        """Return whether rational bounds already show that an edge does not enter the square about J_y."""
        low, high = self.scale.enclosure()
        left, right = min(self.z * low, self.z * high), max(self.z * low, self.z * high) + high
        xs, depths = (dot(a, self.along), dot(b, self.along)), (self.depth(a), self.depth(b))
        return bool(max(xs) <= left or min(xs) >= right or min(depths) >= high or max(depths) <= 0)


def _acute_ends(shape: Shape, curve: OffsetCurve) -> Iterator[_AcuteEnd]:
    before = {h: walk[i - 1] for walks in shape.faces for walk in walks for i, h in enumerate(walk)}
    for s in _straights(shape, curve):
        h, after = s.first.record.corner, s.last.record.corner
        backwards = Point(-s.edge.x, -s.edge.y)
        sides = ((s.first, s.last, s.edge, s.start, Point(-s.first.before.x, -s.first.before.y), before[h], after),
                 (s.last, s.first, backwards, s.end, s.last.after, after, before[h]))
        for corner, other, along, t, u, previous, following in sides:
            if not corner.is_acute:
                continue
            area, product = cross(s.edge, u), dot(along, u)
            local = RealPoint(t.x - corner.p.x, t.y - corner.p.y)
            yield _AcuteEnd(s, corner, other, along, local, product / area, sqrt(curve.mfs_squared * dot(along, along)),
                            area * area / (dot(u, u) * dot(along, along)), h, previous, following)


def _nearest_in_square(end: _AcuteEnd, a: Point, b: Point) -> Real | None:
    """Return the squared distance (times |e|^2) from y to the part of the edge a b inside the open square with the
    sides of J_y, an infimum; None when no part is inside."""
    if end.is_beside(a, b):
        return None
    # Seen from y: to the right towards p2, up towards e.
    right, up = dot(a, end.along) - end.z * end.scale, end.scale - end.depth(a)
    d = minus(b, a)
    to_right, upwards = dot(d, end.along), -end.depth(d)
    low, high = Real(0), Real(1)
    for start, rate in ((right, to_right), (up, upwards), (end.scale - right, -to_right), (end.scale - up, -upwards)):
        if rate == 0:
            if start <= 0:
                return None
        elif rate > 0:
            low = max(low, -start / rate)
        else:
            high = min(high, -start / rate)
    if low >= high:
        return None
    foot = -(right * to_right + up * upwards) / (to_right * to_right + upwards * upwards)
    t = min(max(foot, low), high)
    x, height = right + t * to_right, up + t * upwards
    squared: Real = x * x + height * height
    return squared


def _cosine(corner: Corner) -> Real:
    """Return the cosine of the angle inside P."""
    u, v = corner.before, corner.after
    cosine: Real = -dot(u, v) / sqrt(dot(u, u) * dot(v, v))
    return cosine


def _straights(shape: Shape, curve: OffsetCurve) -> Sequence[Straight]:
    return straights_of(rings_of(shape, curve))


def _convex(shape: Shape, curve: OffsetCurve) -> Iterator[Straight]:
    """Yield the segments between two convex corners, angles of 180 degrees included."""
    return (s for s in _straights(shape, curve) if not s.first.is_reflex and not s.last.is_reflex)


def _see(tally: Tally, straight: Straight, value: mpq | Real) -> None:
    tally.see(value, edge=[straight.first.vertex, straight.last.vertex], at=str(straight.first.p))
