"""Check what the paper says of its Tube before snapping, on algebraic numbers, and the numbers it states.

Values are squares in units of the mfs, squared cosines, or numbers. B, T, R, a, b, a', b' are as in
`paper_tube_check.py`; where T' is all of T, the unsnapped R stands on an edge of P3.

Spokes    a spoke makes at least 45 degrees with the edges of P3 at its end; so it does with T.
Inner     the unsnapped a' and b' are farther than 1/(2 d3) from the lines of the spokes.
Motion    a' and b' are moved by at most 1/(4 d3), in x and y together.
Numbers   0.067 <= 1/(2 d3 sqrt 2), 1/(4 d3) = 1/(16 sqrt 2), 1/(8 d3) = 0.022 in three decimals.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.measure.verdict import Tally, Verdict
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.interval import sign_of
from exactmesh.steps.reading import Reading
from exactmesh.steps.records import CurveCorner, Offset, OffsetCurve, PaperTube, RealPoint, Rectangle, Shape

_OFFSET = mpq(1, 4)
_HALF = mpq(1, 2)


def check_spokes(shape: Shape, curve: OffsetCurve, tops_only: bool) -> Verdict:
    """Return the verdict on the greatest squared cosine of the angle between a spoke and an edge of P3 at its end.

    With `tops_only`, edges of P3 that replace an arc are left out.
    """
    tally = Tally("the angle is at least 45 degrees", "<=", _HALF)
    for ring in curve.rings:
        for corner, following in pairwise((*ring, ring[0])):
            chain = [(v, corner.corner) for v in corner.vertices] + [(following.vertices[0], following.corner)]
            for start, end in pairwise(chain[-2:] if tops_only else chain):
                for (at, source), (other, _) in ((start, end), (end, start)):
                    p = shape.origin[source]
                    cosine_squared = _cosine_squared(_from(at, shape.points[p]), _difference(other, at))
                    tally.see(cosine_squared, edge=corner.corner >> 1, vertex=p)
    return tally.verdict()


def check_inner_corners(shape: Shape, curve: OffsetCurve, p4: Offset, tube: PaperTube, reading: Reading) -> Verdict:
    """Return the verdict on the least squared distance of the unsnapped a' and b' from the spokes at a and b."""
    spacing = reading.inverse_d3 / 2
    tally = Tally("a' and b' are farther than 1/(2 d3) from the sides", ">", spacing * spacing)
    depth = _OFFSET - spacing
    for record, ends, corners in _whole(shape, curve, p4, tube):
        normal = _normal(shape, record)
        for t, corner in zip(ends, corners, strict=True):
            spoke = _from(t, corner)
            beside = depth * (normal.x * spoke.y - normal.y * spoke.x)
            tally.see(beside * beside / (spoke.x * spoke.x + spoke.y * spoke.y), edge=record.edge >> 1)
    return tally.verdict()


def check_motion(shape: Shape, curve: OffsetCurve, p4: Offset, tube: PaperTube, points: Sequence[Point],
                 reading: Reading) -> Verdict:
    """Return the verdict on the greatest squared distance between a', b' and where they would be without snapping.

    Both rectangles have the height 1/4 less the granularity used.
    """
    bound = reading.inverse_d3 / 4
    tally = Tally("a' and b' move by at most 1/(4 d3)", "<=", bound * bound)
    depth = (_OFFSET - reading.granularity) * sqrt(curve.mfs_squared)
    for record, ends, _ in _whole(shape, curve, p4, tube):
        normal = _normal(shape, record)
        for t, below in zip(ends, (record.a_below, record.b_below), strict=True):
            x, y = t.x - depth * normal.x - points[below].x, t.y - depth * normal.y - points[below].y
            tally.see((x * x + y * y) / curve.mfs_squared, edge=record.edge >> 1, vertex=below)
    return tally.verdict()


def check_fan_number(reading: Reading) -> Verdict:
    """Return the verdict on 1/(2 d3 sqrt 2) >= 0.067."""
    tally = Tally("1/(2 d3 sqrt 2) >= 0.067", ">=", mpq(67, 1000))
    tally.see(reading.inverse_d3 / (2 * sqrt(2)), reading=reading.name)
    return tally.verdict()


def check_motion_number(reading: Reading) -> Verdict:
    """Return the verdict on 1/(4 d3) = 1/(16 sqrt 2)."""
    tally = Tally("1/(4 d3) = 1/(16 sqrt 2)", "==", 1 / (16 * sqrt(2)))
    tally.see(reading.inverse_d3 / 4, reading=reading.name)
    return tally.verdict()


def check_low_number(reading: Reading) -> Verdict:
    """Return the verdict on |1/(8 d3) - 0.022| <= 0.0005."""
    tally = Tally("1/(8 d3) is 0.022 in three decimals", "<=", mpq(1, 2000))
    tally.see(abs(reading.inverse_d3 / 8 - mpq(22, 1000)), reading=reading.name)
    return tally.verdict()


def _whole(shape: Shape, curve: OffsetCurve, p4: Offset, tube: PaperTube
           ) -> Iterator[tuple[Rectangle, tuple[RealPoint, RealPoint], tuple[Point, Point]]]:
    """Yield the rectangles that stand on a whole edge of P4, with a and b on P3 and the corners of P beside them."""
    last: dict[int, tuple[CurveCorner, CurveCorner]] = {}
    for ring in curve.rings:
        last |= {corner.corner: (corner, following) for corner, following in pairwise((*ring, ring[0]))}
    for record in tube.rectangles:
        # A whole edge of P4 ends in vertices of P4, which have numbers before those of the chord ends.
        if max(record.side[0], record.side[-1]) < p4.first + len(p4.x):
            start, end = last[record.edge]
            left, right = shape.points[shape.origin[record.edge]], shape.points[shape.origin[record.edge ^ 1]]
            yield record, (start.vertices[-1], end.vertices[0]), (left, right)


def _normal(shape: Shape, record: Rectangle) -> RealPoint:
    """Return the unit normal of an edge of P that points into P."""
    p, q = shape.points[shape.origin[record.edge]], shape.points[shape.origin[record.edge ^ 1]]
    x, y = q.x - p.x, q.y - p.y
    length = sqrt(x * x + y * y)
    return RealPoint(-y / length, x / length)


def _from(t: RealPoint, p: Point) -> RealPoint:
    """Return the vector from t to p."""
    return RealPoint(p.x - t.x, p.y - t.y)


def _difference(a: RealPoint, b: RealPoint) -> RealPoint:
    return RealPoint(a.x - b.x, a.y - b.y)


def _cosine_squared(a: RealPoint, b: RealPoint) -> Real:
    """Return the squared cosine of the angle between a and b; an obtuse angle counts as a right one."""
    if sign_of(lambda ax, ay, bx, by: ax * bx + ay * by, *a, *b) <= 0:
        return Real(0)
    product = a.x * b.x + a.y * b.y
    return Real(product * product / ((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y)))
