"""Decide exactly, by one sweep, that a PSLG is one, and what lies directly below each vertex.

The sweep is Shamos and Hoey's ("Geometric intersection problems", 1976): vertices in lexicographic order, the edges
cut by the sweep line in vertical order, two edges compared when they become neighbours. The first place where two
features meet is found before the order is first wrong. O((n + m) log n) predicates; no recursion.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import pairwise

from exactmesh.errors import GeometryError
from exactmesh.geometry.fixed_point import FixedPoints, TurnFilter
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import line_crossing
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.status import Status


class VerticesCoincide(GeometryError):
    """Two vertices are the same point."""

    def __init__(self, first: int, second: int, at: Point) -> None:
        super().__init__(f"vertices {first} and {second} coincide at {at}")
        self.first, self.second, self.at = first, second, at


class VertexOnEdge(GeometryError):
    """A vertex lies in the interior of an edge."""

    def __init__(self, vertex: int, edge: int, ends: Edge, at: Point) -> None:
        super().__init__(f"vertex {vertex} lies on edge {edge} {ends} at {at}")
        self.vertex, self.edge, self.ends, self.at = vertex, edge, ends, at


class EdgesOverlap(GeometryError):
    """Two edges share more than a point."""

    def __init__(self, first: int, second: int, ends: tuple[Edge, Edge], at: Point) -> None:
        super().__init__(f"edges {first} {ends[0]} and {second} {ends[1]} overlap from {at}")
        self.first, self.second, self.ends, self.at = first, second, ends, at


class EdgesCross(GeometryError):
    """Two edges meet in a point interior to both."""

    def __init__(self, first: int, second: int, ends: tuple[Edge, Edge], at: Point) -> None:
        super().__init__(f"edges {first} {ends[0]} and {second} {ends[1]} cross at {at}")
        self.first, self.second, self.ends, self.at = first, second, ends, at


class HolePointOnBoundary(GeometryError):
    """A hole point lies on a vertex or an edge, so it marks no face."""

    def __init__(self, hole: int, feature: str, at: Point) -> None:
        super().__init__(f"hole point {hole} at {at} lies on {feature}: it must lie inside a face")
        self.hole, self.at = hole, at


@dataclass(frozen=True, slots=True)
class Below:
    """The edge met first on the way down from each vertex and hole point; -1 where there is none.

    Down is the direction (0, -1), turned infinitesimally counter-clockwise so that no edge is vertical. Edges at a
    vertex itself do not count.
    """

    vertex: tuple[int, ...]
    hole: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Swept:
    """What a sweep found out. `rank` has the place of each vertex in lexicographic order; `turns` are of the vertices
    and then the hole points."""

    below: Below
    rank: Sequence[int]
    turns: TurnFilter


def validate(pslg: Pslg) -> Below:
    """Return what lies below each vertex and hole point of a PSLG without defects.

    Raises the `GeometryError` of the first defect met from left to right: `VerticesCoincide`, `VertexOnEdge`,
    `EdgesOverlap`, `EdgesCross`, `HolePointOnBoundary`.
    """
    return swept(pslg).below


def swept(pslg: Pslg) -> Swept:
    """Return `validate(pslg)` with what else the sweep knows; raises what `validate` raises."""
    return _Sweep(pslg).run()


class _Sweep:
    """One sweep. `status` holds the active edges from below; `left[e]`, `right[e]` are its ends in sweep order."""

    def __init__(self, pslg: Pslg) -> None:
        self.pslg = pslg
        self.count = len(pslg.vertices)
        self.points: Sequence[Point] = pslg.vertices + pslg.holes
        columns = FixedPoints(self.points)
        self.turns = TurnFilter(columns)
        self.orientation = self.turns.orientation
        # A hole point sorts after a vertex at the same place.
        self.order: list[int] = columns.lexicographic().tolist()
        self.rank = [0] * len(self.order)
        for place, v in enumerate(self.order):
            self.rank[v] = place
        self.left: list[int] = []
        self.right: list[int] = []
        self.starting: list[list[int]] = [[] for _ in range(self.count)]
        # One of the edges that end at each vertex, -1 where there is none.
        self.ending = [-1] * self.count
        self.status = Status(len(pslg.edges))
        for edge, (u, v) in enumerate(pslg.edges):
            if self.rank[v] < self.rank[u]:
                u, v = v, u
            self.left.append(u)
            self.right.append(v)
            self.starting[u].append(edge)
            self.ending[v] = edge

    def run(self) -> Swept:
        below = [-1] * len(self.points)
        order = self.order
        for i, v in enumerate(order):
            # Looked at before the sweep line passes v: an edge that ends at `order[i + 1]` is no edge through v.
            if v < self.count and i + 1 < len(order) and self.points[order[i + 1]] == self.points[v]:
                self._coincide(v, order[i + 1])
            below[v] = self._pass(v)
        self.turns.note()
        return Swept(Below(tuple(below[: self.count]), tuple(below[self.count :])), self.rank, self.turns)

    def _coincide(self, first: int, second: int) -> None:
        at = self.points[first]
        if second >= self.count:
            raise HolePointOnBoundary(second - self.count, f"vertex {first}", at)
        raise VerticesCoincide(first, second, at)

    def _pass(self, v: int) -> int:
        """Move the sweep line over the point v; return the edge directly below it."""
        orientation, left, right, status = self.orientation, self.left, self.right, self.status

        def ends_here(edge: int) -> bool:
            if right[edge] == v:
                return True
            if orientation(left[edge], right[edge], v) == 0:
                self._on_edge(v, edge)
            return False

        if v < self.count and self.ending[v] >= 0:
            # The edges through v follow each other in the status.
            at = status.place(self.ending[v])
            while ((below := status.before(at)) >= 0
                   and (right[below] == v or orientation(left[below], right[below], v) == 0)):
                at = status.previous(at) or at
        else:
            at = status.first(lambda edges: self.turns.count_below(edges, left, right, v))
            below = status.before(at)
        ending, above = status.run(at, ends_here)
        if v >= self.count:
            return below
        starting = self._sorted_by_slope(v)
        status.replace(at, len(ending), starting)
        if starting:
            if below >= 0:
                self._compare_new(starting[0], below, 1)
            if above >= 0:
                self._compare_new(starting[-1], above, -1)
        elif below >= 0 and above >= 0:
            self._compare(below, above)
        return below

    def _on_edge(self, v: int, edge: int) -> None:
        if v >= self.count:
            raise HolePointOnBoundary(v - self.count, self._named(edge), self.points[v])
        raise VertexOnEdge(v, edge, self.pslg.edges[edge], self.points[v])

    def _named(self, edge: int) -> str:
        return f"edge {edge} {self.pslg.edges[edge]}"

    def _sorted_by_slope(self, v: int) -> list[int]:
        """Return the edges that start at v from below; raise when two of them leave in one direction."""
        starting = self.starting[v]
        if len(starting) < 2:
            return starting
        turn = self.orientation

        def steeper(e: int, f: int) -> int:
            return turn(v, self.right[f], self.right[e])

        ordered = sorted(starting, key=cmp_to_key(steeper))
        for e, f in pairwise(ordered):
            if turn(v, self.right[e], self.right[f]) == 0:
                first, second = sorted((e, f))
                edges = self.pslg.edges
                raise EdgesOverlap(first, second, (edges[first], edges[second]), self.points[v])
        return ordered

    def _compare(self, e: int, f: int) -> None:
        """Raise when the neighbours e and f, neither of which is behind the sweep line, cross or touch."""
        a, b, c, d = self.left[e], self.right[e], self.left[f], self.right[f]
        if a != c and b != d and self._is_between(a, b, c, d) and self._is_between(c, d, a, b):
            self._cross(e, f)

    def _compare_new(self, e: int, f: int, side: int) -> None:
        """Raise when e, which starts at the vertex that the sweep line has just reached, crosses its neighbour f.

        The vertex is on the left of f (`side` 1) or on the right (-1). An end of an edge on another one is met again,
        as a vertex on an edge, when the sweep line reaches it.
        """
        a, b, c, d = self.left[e], self.right[e], self.left[f], self.right[f]
        if b != d and self.orientation(c, d, b) == -side and self._is_between(a, b, c, d):
            self._cross(e, f)

    def _is_between(self, a: int, b: int, c: int, d: int) -> bool:
        """Return whether the line through a and b has c and d strictly on different sides."""
        side = self.orientation(a, b, c)
        return side != 0 and self.orientation(a, b, d) == -side

    def _cross(self, e: int, f: int) -> None:
        at = line_crossing(*(self.points[i] for i in (self.left[e], self.right[e], self.left[f], self.right[f])))
        first, second = sorted((e, f))
        raise EdgesCross(first, second, (self.pslg.edges[first], self.pslg.edges[second]), at)
