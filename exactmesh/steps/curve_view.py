"""For checkers: the paper's P2 and P3 beside the polygon they are said to belong to.

Nothing is judged here. A record that names a half-edge of P is taken at its word and set beside that half-edge's
corner; a missing record shows as a P2 with too few corners (`offset_curve_check.check_single_curve`).
"""

from collections.abc import Sequence
from dataclasses import dataclass

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.measure.algebraic_mfs import Label
from exactmesh.numbers.algebraic import Real
from exactmesh.planar.pslg import Edge
from exactmesh.steps.records import CurveCorner, OffsetCurve, RealPoint, Shape


@dataclass(frozen=True, slots=True)
class Corner:
    """Corner p of P, the vertex `vertex`, between the edges `before` and `after` (vectors along the walk)."""

    vertex: int
    p: Point
    before: Point
    after: Point
    record: CurveCorner

    @property
    def is_flat(self) -> bool:
        """Whether the angle is 180 degrees."""
        return bool(cross(self.before, self.after) == 0 and dot(self.before, self.after) > 0)

    @property
    def is_reflex(self) -> bool:
        """Whether the angle inside P is above 180 degrees."""
        return bool(cross(self.before, self.after) <= 0) and not self.is_flat

    @property
    def is_acute(self) -> bool:
        """Whether the angle inside P is below 90 degrees."""
        return bool(cross(self.before, self.after) > 0 and dot(self.before, self.after) < 0)

    @property
    def ends(self) -> tuple[RealPoint, RealPoint]:
        """Where P2's segment along `before` ends and the one along `after` starts."""
        record = self.record
        return record.arc or (record.vertices[0], record.vertices[-1])


@dataclass(frozen=True, slots=True)
class Straight:
    """The straight segment of P2 that belongs to the edge of P from corner `first` to corner `last`."""

    first: Corner
    last: Corner

    @property
    def edge(self) -> Point:
        """The edge of P, as a vector."""
        return self.first.after

    @property
    def start(self) -> RealPoint:
        """Its first end."""
        return self.first.ends[1]

    @property
    def end(self) -> RealPoint:
        """Its last end."""
        return self.last.ends[0]

    def length_squared(self) -> Real:
        """Return its squared length, negative when it runs against its edge."""
        x, y = self.end.x - self.start.x, self.end.y - self.start.y
        squared = x * x + y * y
        return squared if (x * self.edge.x + y * self.edge.y).sign() >= 0 else -squared


def rings_of(shape: Shape, curve: OffsetCurve) -> list[list[Corner]]:
    """Return the corners of each ring of the curve in its order."""
    before = {h: walk[i - 1] for walks in shape.faces for walk in walks for i, h in enumerate(walk)}
    vectors = {h: minus(shape.points[shape.origin[h ^ 1]], shape.points[shape.origin[h]]) for h in before}
    return [[Corner(shape.origin[c.corner], shape.points[shape.origin[c.corner]], vectors[before[c.corner]],
                    vectors[c.corner], c) for c in ring] for ring in curve.rings]


def straights_of(rings: Sequence[Sequence[Corner]]) -> list[Straight]:
    """Return the straight segments of P2, each from a corner to the next one of its ring."""
    return [Straight(corner, ring[(i + 1) % len(ring)]) for ring in rings for i, corner in enumerate(ring)]


@dataclass(frozen=True, slots=True)
class Polygons:
    """P3 as a graph. `labels[v]` is the vertex of P that vertex v belongs to; `edge_labels[e]` the two ends of the edge
    of P that edge e belongs to, or twice the vertex whose arc it is a chord of."""

    places: tuple[RealPoint, ...]
    labels: tuple[int, ...]
    edges: tuple[Edge, ...]
    edge_labels: tuple[Label, ...]


def p3_of(rings: Sequence[Sequence[Corner]]) -> Polygons:
    """Return P3 as a graph, its vertices in the order of the records."""
    places: list[RealPoint] = []
    labels: list[int] = []
    edges: list[Edge] = []
    for ring in rings:
        start = len(places)
        for corner in ring:
            places.extend(corner.record.vertices)
            labels.extend([corner.vertex] * len(corner.record.vertices))
        edges.extend((v, v + 1 if v + 1 < len(places) else start) for v in range(start, len(places)))
    return Polygons(tuple(places), tuple(labels), tuple(edges), tuple((labels[v], labels[w]) for v, w in edges))


def decimal_place(place: tuple[Real, Real]) -> str:
    """Return a place for reading."""
    return f"({place[0].decimal()}, {place[1].decimal()})"
