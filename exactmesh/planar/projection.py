"""Cut the constrained sides of a Delaunay triangulation below the vertices opposite to them.

A long edge across from many vertices makes triangles so thin that a vertex has many of their sides nearby. With its
feet on the edge for vertices, the triangulation is as fine near the edge as the vertices are. The new vertices lie
exactly on the edges, near the feet; they serve a search and are no part of a mesh.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.filtered import unit_floats
from exactmesh.geometry.incircle import CirclePoints
from exactmesh.geometry.point import Point
from exactmesh.planar.cycles import Side
from exactmesh.planar.delaunay import flip
from exactmesh.planar.pslg import Edge
from exactmesh.planar.triangulation import Triangulation, triangles_from

# Where an edge is cut is rounded to this fraction of its length.
_PARTS = 2**40
# Cuts for each vertex of the input: a bound that only very unfavourable inputs meet.
_CUTS = 4


@dataclass(frozen=True, slots=True)
class Projected:
    """`points` begins with the given ones; `edge_of` has, for the constrained sides that were cut, the whole edges."""

    points: tuple[Point, ...]
    triangulation: Triangulation
    edge_of: Mapping[Side, Edge]


def project(points: Sequence[Point], triangulation: Triangulation, shortest: float) -> Projected:
    """Return the triangulation after cutting constrained sides longer than `shortest` at the feet of vertices.

    `shortest` is in the unit of `unit_floats(points)`.
    """
    return _Projection(points, triangulation, shortest).run()


class _Projection:
    """`at[v]` is the place of a new vertex v on its edge, from 0 to 1."""

    def __init__(self, points: Sequence[Point], triangulation: Triangulation, shortest: float) -> None:
        self.points = list(points)
        self.given = len(points)
        self.apex = dict(triangulation.apex)
        self.constrained = set(triangulation.constrained)
        self.shortest = shortest
        self.x, self.y, _ = unit_floats(points)
        self.edge_of: dict[Side, Edge] = {}
        self.at: dict[int, mpq] = {}

    def run(self) -> Projected:
        pending = [side for side in self.apex if side in self.constrained]
        # Circles are decided exactly or by floats over one growing list of points.
        circles = _Circles(self.points)
        while pending and len(self.points) < (1 + _CUTS) * self.given:
            side = pending.pop()
            if side not in self.constrained or side not in self.apex:
                continue
            middle = self._foot(side)
            if middle is None:
                continue
            circles.append(middle)
            changed = flip(self.apex, self.constrained, circles.in_circle, self._cut(side))
            pending += changed or []
            m = len(self.points) - 1
            pending += [s for s in ((side[0], m), (m, side[1]), (side[1], m), (m, side[0])) if s in self.apex]
        triangulation = Triangulation(triangles_from(self.apex), frozenset(self.constrained), self.apex)
        return Projected(tuple(self.points), triangulation, self.edge_of)

    def _foot(self, side: Side) -> Point | None:
        """Return about the foot on a side of the vertex opposite to it, when it lies well inside."""
        a, b = side
        u, v = self.edge_of.get(side, side)
        w = self.apex[side]
        if w >= self.given:
            return None
        dx, dy = self.x[v] - self.x[u], self.y[v] - self.y[u]
        length_squared = dx * dx + dy * dy
        if length_squared <= self.shortest * self.shortest:
            return None
        t = ((self.x[w] - self.x[u]) * dx + (self.y[w] - self.y[u]) * dy) / length_squared
        low, high = sorted((self._place(a, u), self._place(b, u)))
        margin = self.shortest / 2 / length_squared**0.5
        part = mpq(round(t * _PARTS), _PARTS)
        if not (float(low) + margin < t < float(high) - margin and low < part < high):
            return None
        self.at[len(self.points)] = part
        p, q = self.points[u], self.points[v]
        return Point(p.x + part * (q.x - p.x), p.y + part * (q.y - p.y))

    def _place(self, a: int, u: int) -> mpq:
        """Return the place of an end of a side on an edge that begins at u."""
        return self.at[a] if a >= self.given else mpq(a != u)

    def _cut(self, side: Side) -> list[Side]:
        """Cut a side at the last point, in the triangles on either side; return the sides to look at for flips."""
        u, v = side
        m = len(self.points) - 1
        edge = self.edge_of.get(side, side)
        around = []
        for a, b in ((u, v), (v, u)):
            self.constrained.remove((a, b))
            self.constrained |= {(a, m), (m, b)}
            self.edge_of[a, m] = self.edge_of[m, b] = edge
            w = self.apex.pop((a, b), -1)
            if w >= 0:
                self.apex[a, m] = self.apex[m, b] = w
                self.apex[b, w] = self.apex[w, a] = m
                self.apex[m, w], self.apex[w, m] = a, b
                around += [(b, w), (w, a), (m, w)]
        return [outer for outer in around if outer not in self.constrained]


class _Circles(CirclePoints):
    """`CirclePoints` over a list that grows by points between those that it began with."""

    __slots__ = ("_centre", "_list", "_scale")

    def __init__(self, points: list[Point]) -> None:
        super().__init__(points)
        self._list = points
        xs, ys = [p.x for p in points], [p.y for p in points]
        self._centre = Point((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
        _, _, self._scale = unit_floats([Point(min(xs), min(ys)), Point(max(xs), max(ys))])

    def append(self, p: Point) -> None:
        """Append a point to the list."""
        self._list.append(p)
        self._x.append(float((p.x - self._centre.x) / self._scale))
        self._y.append(float((p.y - self._centre.y) / self._scale))
