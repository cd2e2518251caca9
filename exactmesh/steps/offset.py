"""Offset every face inwards by a fixed octagon, with all vertices on levels: P to Q (in place of paper §2, P2 to P4).

In      `Shape`.
Out     `Offset`.
Exact   rational: the normal (-dy, dx) of an edge enters only through signs; a convex corner is a crossing of two
        lines. Levels are y = (j + 1/2) g with integer j; x is kept, y goes to the nearest level.
Paper   takes a disc of radius 1/4, replaces arcs by chords and snaps each vertex by itself. Here the body K1 has its
        vertices half a level off the levels, so the cap of a reflex corner moves rigidly when it is snapped, and the
        body is enlarged beforehand by what snapping can take away.
Check   `offset_check.py`
"""

from collections.abc import Iterator

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import ball_of
from exactmesh.geometry.columns import Columns, Vectors, indices
from exactmesh.geometry.decisions import note
from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.geometry.predicates import line_crossing
from exactmesh.steps.balance import REPAIRED, Balance
from exactmesh.steps.records import Offset, Shape

_HALF = mpq(1, 2)
_SIZE = 8


class _Body:
    """The vertices of K1 counter-clockwise, as (x, number of the level relative to the centre's), y = (number + 1/2) g,
    and as points."""

    def __init__(self, balance: Balance) -> None:
        a, b, top = balance.flat, balance.wide, balance.crown
        self.places = ((b, -1), (b, 0), (a, top), (-a, top), (-b, 0), (-b, -1), (-a, -top - 1), (a, -top - 1))
        self.points = tuple(Point(x, (j + _HALF) * balance.level) for x, j in self.places)


def offset(shape: Shape, balance: Balance = REPAIRED) -> Offset:
    """Return the inner offset of every face of `shape`, one ring a walk and one an isolated vertex."""
    build = _Build(shape, balance)
    for walks, isolated in zip(shape.faces, shape.isolated, strict=True):
        for walk in walks:
            build.ring(walk)
        for v in isolated:
            build.ring_around(v)
    return build.finished()


class _Build:
    """Collects the vertices of Q ring by ring."""

    def __init__(self, shape: Shape, balance: Balance) -> None:
        self.shape = shape
        self.spacing = balance.level
        self.body = _Body(balance)
        self.extreme = _extremes(shape, self.body)
        self.x: list[mpq] = []
        self.level: list[int] = []
        self.corner: list[int] = []
        self.source: list[int] = []
        self.rings: list[tuple[int, int]] = []

    def ring(self, walk: tuple[int, ...]) -> None:
        start = len(self.x)
        for incoming, outgoing in zip((walk[-1], *walk[:-1]), walk, strict=True):
            for x, level in self._corner(incoming, outgoing):
                self._add(x, level, outgoing, source=-1)
            self.source[-1] = outgoing
        self.rings.append((start, len(self.x)))

    def ring_around(self, v: int) -> None:
        start = len(self.x)
        for x, level in self._placed(self.shape.points[v], range(_SIZE - 1, -1, -1)):
            self._add(x, level, -1 - v, source=-1)
        self.rings.append((start, len(self.x)))

    def finished(self) -> Offset:
        # Vertices on one level share their ordinate.
        height = {j: (j + _HALF) * self.spacing for j in set(self.level)}
        points = tuple(Point(x, height[j]) for x, j in zip(self.x, self.level, strict=True))
        return Offset(len(self.shape.points), tuple(self.x), tuple(self.level), tuple(self.corner),
                      tuple(self.source), tuple(self.rings), points, self.spacing)

    def _add(self, x: mpq, level: int, corner: int, source: int) -> None:
        self.x.append(x)
        self.level.append(level)
        self.corner.append(corner)
        self.source.append(source)

    def _corner(self, incoming: int, outgoing: int) -> Iterator[tuple[mpq, int]]:
        """Yield the vertices of Q of one corner as (x, level), in the order of the walk."""
        points, origin = self.shape.points, self.shape.origin
        p = points[origin[outgoing]]
        before, after = points[origin[incoming]], points[origin[outgoing ^ 1]]
        ext0, ext1 = self.extreme[incoming], self.extreme[outgoing]
        common = [k for k in ext0 if k in ext1]
        if common:
            yield from self._placed(p, common[:1])
        elif _is_reflex(minus(p, before), minus(after, p)):
            yield from self._placed(p, _clockwise_run(ext0, ext1))
        else:
            k0, k1 = self.body.points[ext0[0]], self.body.points[ext1[0]]
            met = line_crossing(_plus(before, k0), _plus(p, k0), _plus(p, k1), _plus(after, k1))
            yield met.x, _floor(met.y / self.spacing)

    def _placed(self, p: Point, run: "range | list[int]") -> Iterator[tuple[mpq, int]]:
        """Yield vertices of the body about p, moved rigidly so that its centre's y is a whole number of levels."""
        whole = _floor(p.y / self.spacing + _HALF)
        for k in run:
            x, level = self.body.places[k]
            yield p.x + x, whole + level


def _is_reflex(e0: Point, e1: Point) -> bool:
    """Return whether the angle inside is above 180 degrees, between edges without a common extreme vertex."""
    turn = cross(e0, e1)
    return bool(turn < 0 or (turn == 0 and dot(e0, e1) < 0))


def _extremes(shape: Shape, body: _Body) -> list[list[int]]:
    """Return `_extreme` of every half-edge."""
    points, origin = Columns(shape.points), indices(shape.origin)
    start, end = origin[::2], origin[1::2]
    along = points.vectors(start, end)
    values = [along.cross(Vectors(ball_of(k.x), ball_of(k.y))) for k in body.points]
    low, high = np.stack([value.low() for value in values]), np.stack([value.high() for value in values])
    best, every = np.argmax(low, axis=0), np.arange(len(start))
    least = low[best, every]
    high[best, every] = -np.inf
    sure = least > high.max(axis=0)
    note("extreme vertex", len(start), int((~sure).sum()))
    found: list[list[int]] = []
    for edge, (k, is_sure) in enumerate(zip(best.tolist(), sure.tolist(), strict=True)):
        p, q = shape.points[shape.origin[2 * edge]], shape.points[shape.origin[2 * edge + 1]]
        found.append([k] if is_sure else _extreme(minus(q, p), body))
        # The body is its own image by the point reflection at its centre.
        found.append(sorted((k + _SIZE // 2) % _SIZE for k in found[-1]))
    return found


def _extreme(edge: Point, body: _Body) -> list[int]:
    """Return the one or two vertices of K1 farthest along the inner normal (-dy, dx) of an edge."""
    values = [cross(edge, k) for k in body.points]
    most = max(values)
    return [k for k, value in enumerate(values) if value == most]


def _clockwise_run(ext0: list[int], ext1: list[int]) -> list[int]:
    """Return the shortest run of body vertices met clockwise from one of `ext0` to one of `ext1`."""
    return min(([(k - i) % _SIZE for i in range((k - last) % _SIZE + 1)] for k in ext0 for last in ext1), key=len)


def _plus(a: Point, b: Point) -> Point:
    return Point(a.x + b.x, a.y + b.y)


def _floor(value: mpq) -> int:
    """One rounding for all vertices, which keeps it monotone: caps and convex corners agree on ties."""
    return int(value.numerator // value.denominator)
