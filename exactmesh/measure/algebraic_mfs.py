"""Least distances between vertices and edges whose places are algebraic, exactly.

Floats choose candidates, intervals of 256 bits tell most of them apart, exact signs decide the rest.

Why candidates for rational points are candidates for algebraic places: `approximated` is within 2^-80 of the extent,
and `nearest_candidates` is told so. Where `SLACK` is used, its proof needs coordinates that are within 2^-52 once they
are scaled into [-1, 1]: 2^-80 of the extent is at most 2^-78 there, and turning that into a double costs at most 2^-53.

Among pairs that 256 bits do not tell apart the first is reported as the least; the bound is decided exactly for every
one of them, so `Least.holds` does not depend on which of them is the true least.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.filtered import unit_floats
from exactmesh.geometry.point import Point
from exactmesh.measure.candidates import SLACK, nearest_candidates
from exactmesh.measure.verdict import Relation
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.interval import sign_of
from exactmesh.planar.pslg import Edge

Place = tuple[Real, Real]
Label = tuple[int, int]
_ZERO = mpq(0)
_BITS = 256
_ROW = 256


@dataclass(frozen=True, slots=True)
class Least:
    """The least squared distance found, between `vertex` and `edge`, and whether it is within the bound."""

    squared: Real
    vertex: int
    edge: Edge
    holds: bool


@dataclass(frozen=True, slots=True)
class Labelled:
    """Vertices and edges to be compared with each other, of places that both refer to.

    A vertex with label l is not compared with an edge that has l among its two labels.
    """

    vertices: Sequence[int]
    labels: Sequence[int]
    edges: Sequence[Edge]
    edge_labels: Sequence[Label]


def real_place(p: Point) -> Place:
    """Return a rational point as a place."""
    return Real(p.x), Real(p.y)


def algebraic_mfs(places: Sequence[Place], edges: Sequence[Edge], relation: Relation = ">=",
                  bound: mpq | Real = _ZERO) -> Least | None:
    """Return the least squared distance between a place and an edge that does not contain it, for a graph in which
    every vertex is on an edge and every edge meets another; None when there is no pair."""
    points = approximated(places)
    # The extent of the places is above that of the points by less than a part of 2^-78.
    pairs = nearest_candidates(points, edges, _extent(points) / mpq(2) ** 79)
    return _least(places, [(v, edges[e]) for v, e in pairs], relation, bound)


def least_between(places: Sequence[Place], groups: Sequence[Labelled], relation: Relation = ">=",
                  bound: mpq | Real = _ZERO) -> Least | None:
    """Return the least squared distance over all pairs of all groups; None when there is none. Quadratic."""
    if not places:
        return None
    x, y, _ = unit_floats(approximated(places))
    xy = np.array([x, y]).T
    found = sorted(near for group in groups for near in _near_pairs(xy, group))
    reach = found[0][0] + SLACK if found else 0.0
    pairs = [(v, edge) for distance, v, edge in found if distance <= reach]
    return _least(places, pairs, relation, bound)


def approximated(places: Sequence[Place]) -> list[Point]:
    """Return rational points within 2^-80 of the extent of all places."""
    if all(place == places[0] for place in places):
        return [Point(mpq(0), mpq(0))] * len(places)
    bits = _BITS // 2
    while True:
        intervals = [[coordinate.interval(bits) for coordinate in place] for place in places]
        ends = [[(mpq(i.low), mpq(i.high)) for i in axis] for axis in zip(*intervals, strict=True)]
        width = max(high - low for axis in ends for low, high in axis)
        extent = max(max(high for _, high in axis) - min(low for low, _ in axis) for axis in ends)
        # `extent` is at most 2 `width` too great.
        if width * mpq(2) ** 82 <= extent:
            return [Point(x[0], y[0]) for x, y in zip(*ends, strict=True)]
        bits *= 2


def _extent(points: Sequence[Point]) -> mpq:
    axes = list(zip(*points, strict=True))
    return max((max(axis) - min(axis) for axis in axes), default=_ZERO)


def _near_pairs(xy: Any, group: Labelled) -> list[tuple[float, int, Edge]]:
    """Return the pairs of one group that may have its least distance, with the rounded distance."""
    if not group.vertices or not group.edges:
        return []
    vertices, labels = np.array(group.vertices), np.array(group.labels)
    ends, edge_labels = np.array(group.edges), np.array(group.edge_labels)
    a = xy[ends[:, 0]]
    d = xy[ends[:, 1]] - a
    length_squared = (d * d).sum(axis=1)
    reach = np.inf
    found: list[tuple[float, int, Edge]] = []
    rows = list(pairwise([*range(0, len(vertices), _ROW), len(vertices)]))
    for start, end in rows:
        q = xy[vertices[start:end], None, :] - a
        along = (q * d).sum(axis=2)
        t = np.clip(np.divide(along, length_squared, out=np.zeros_like(along), where=length_squared > 0), 0, 1)
        foot = q - t[:, :, None] * d
        distance = np.hypot(foot[:, :, 0], foot[:, :, 1])
        distance[(edge_labels[None, :, :] == labels[start:end, None, None]).any(axis=2)] = np.inf
        reach = min(reach, float(distance.min()))
        near = np.argwhere(np.isfinite(distance) & (distance <= reach + SLACK))
        found += [(float(distance[i, j]), int(vertices[start + i]), group.edges[j]) for i, j in near.tolist()]
    return [near for near in found if near[0] <= reach + SLACK]


class _Distance:
    """The squared distance of a vertex from an edge, top/bottom, both polynomials in the six coordinates."""

    def __init__(self, places: Sequence[Place], vertex: int, edge: Edge) -> None:
        self.vertex, self.edge = vertex, edge
        self.values = (*places[vertex], *places[edge[0]], *places[edge[1]])
        self.top: Callable[..., Any] = _area_squared
        self.bottom: Callable[..., Any] | None = _length_squared
        if sign_of(_beyond_start, *self.values) <= 0:
            self.top, self.bottom = _start_squared, None
        elif sign_of(_beyond_end, *self.values) >= 0:
            self.top, self.bottom = _end_squared, None
        self.low, self.high = self._bounds()

    def exact(self) -> Real:
        """Return the squared distance."""
        top = self.top(*self.values)
        value: Real = top if self.bottom is None else top / self.bottom(*self.values)
        return value

    def satisfies(self, relation: Relation, bound: Real) -> bool:
        """Return whether the squared distance is >= or > the bound."""

        def excess(*values: Any) -> Any:
            *coordinates, limit = values
            top = self.top(*coordinates)
            return top - limit if self.bottom is None else top - limit * self.bottom(*coordinates)

        sign = sign_of(excess, *self.values, bound)
        return sign > 0 or (sign == 0 and relation == ">=")

    def _bounds(self) -> tuple[mpq, mpq]:
        bits = _BITS
        while True:
            intervals = [value.interval(bits) for value in self.values]
            top = self.top(*intervals)
            if self.bottom is None:
                return mpq(top.low), mpq(top.high)
            bottom = self.bottom(*intervals)
            if bottom.low > 0:
                return max(mpq(top.low), mpq(0)) / mpq(bottom.high), mpq(top.high) / mpq(bottom.low)
            bits *= 2


def _least(places: Sequence[Place], pairs: Sequence[tuple[int, Edge]], relation: Relation, bound: mpq | Real
           ) -> Least | None:
    distances = [_Distance(places, v, edge) for v, edge in pairs]
    if not distances:
        return None
    reach = min(distance.high for distance in distances)
    tied = [distance for distance in distances if distance.low <= reach]
    limit = Real(bound)
    offender = next((distance for distance in tied if not distance.satisfies(relation, limit)), None)
    worst = offender or tied[0]
    return Least(worst.exact(), worst.vertex, worst.edge, offender is None)


def _start_squared(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    return (px - ax) * (px - ax) + (py - ay) * (py - ay)


def _end_squared(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    return (px - bx) * (px - bx) + (py - by) * (py - by)


def _length_squared(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    return (bx - ax) * (bx - ax) + (by - ay) * (by - ay)


def _area_squared(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    area = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
    return area * area


def _beyond_start(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """Return a number that is positive when the foot of the perpendicular lies beyond the edge's first end."""
    return (bx - ax) * (px - ax) + (by - ay) * (py - ay)


def _beyond_end(px: Any, py: Any, ax: Any, ay: Any, bx: Any, by: Any) -> Any:
    """Return a number that is positive when the foot of the perpendicular lies beyond the edge's second end."""
    return (bx - ax) * (px - bx) + (by - ay) * (py - by)
