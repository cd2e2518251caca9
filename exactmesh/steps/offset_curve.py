"""The paper's offset curve and its refinement: P to P2 and P3 (paper §2, "Refinement of P2", Fig. 4 and 5).

In      `Shape` with unit 1, of polygons; M, the squared mfs; which rule an arc of exactly 90 degrees follows.
Out     `OffsetCurve`.
Exact   algebraic: with u the inner unit normals of the two edges at a corner p and r = mfs/4, a convex corner moves
        to p + r (u0 + u1)/(1 + u0.u1); so does a reflex one whose arc is prolonged; the middle of an arc is
        p + r (u0 + u1)/|u0 + u1|. One square root sqrt(M/B) an edge of squared length B, one nested root an arc.
Paper   an arc over 90 degrees becomes two chords, one under 90 degrees is prolonged. It does not say what happens at
        90 degrees: `right_angle` does. A half circle (a dangling end) is treated as an arc over 90 degrees.
Check   `offset_curve_check.py`
"""

from typing import Literal

from gmpy2 import mpq

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.steps.records import CurveCorner, OffsetCurve, RealPoint, Shape

RightAngle = Literal["chords", "prolonged"]


def offset_curve(shape: Shape, mfs_squared: mpq, right_angle: RightAngle = "chords") -> OffsetCurve:
    """Return P2 and P3 of every walk of `shape`: corners in the order of the walk."""
    return OffsetCurve(mfs_squared, tuple(
        tuple(_corner(shape, mfs_squared, incoming, outgoing, right_angle)
              for incoming, outgoing in zip((walk[-1], *walk[:-1]), walk, strict=True))
        for walks in shape.faces for walk in walks))


def _corner(shape: Shape, mfs_squared: mpq, incoming: int, outgoing: int, right_angle: RightAngle) -> CurveCorner:
    points, origin = shape.points, shape.origin
    p = points[origin[outgoing]]
    e0, e1 = minus(p, points[origin[incoming]]), minus(points[origin[outgoing ^ 1]], p)
    turn, ahead = cross(e0, e1), dot(e0, e1)
    to_first, to_second = _normal(e0, mfs_squared), _normal(e1, mfs_squared)
    if turn == 0 and ahead > 0:
        return CurveCorner("flat", outgoing, (_plus(p, to_first),))
    is_reflex = turn < 0 or turn == 0
    over_right = ahead < 0 or (ahead == 0 and right_angle == "chords")
    if not is_reflex or not over_right:
        vertex = _plus(p, _scaled(_plus(to_first, to_second), 1 / (1 + _cosine(e0, e1))))
        if not is_reflex:
            return CurveCorner("convex", outgoing, (vertex,))
        return CurveCorner("prolonged", outgoing, (vertex,), (_plus(p, to_first), _plus(p, to_second)))
    ends = _plus(p, to_first), _plus(p, to_second)
    if turn == 0:
        # Half a circle: its middle lies straight ahead, beyond the dangling end.
        middle = _plus(p, RealPoint(to_first.y, -to_first.x))
    else:
        # |u0 + u1|^2 = 2 + 2 u0.u1
        middle = _plus(p, _scaled(_plus(to_first, to_second), 1 / (2 + 2 * _cosine(e0, e1)).sqrt()))
    return CurveCorner("chords", outgoing, (ends[0], middle, ends[1]), ends)


def _normal(edge: Point, mfs_squared: mpq) -> RealPoint:
    """Return the inner normal of an edge with length mfs/4."""
    factor = sqrt(mfs_squared / dot(edge, edge)) / 4
    return RealPoint(-edge.y * factor, edge.x * factor)


def _cosine(e0: Point, e1: Point) -> Real:
    """Return the cosine of the angle between two edges."""
    cosine: Real = dot(e0, e1) / sqrt(dot(e0, e0) * dot(e1, e1))
    return cosine


def _plus(a: Point | RealPoint, b: RealPoint) -> RealPoint:
    return RealPoint(a.x + b.x, a.y + b.y)


def _scaled(a: RealPoint, factor: Real) -> RealPoint:
    return RealPoint(a.x * factor, a.y * factor)
