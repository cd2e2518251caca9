"""Vertex-feature pairs that may realise the minimum feature size, found with floats and missing none.

A k-d tree over the vertices is walked level by level in arrays: a cell keeps the features (segments, or points as
segments of length zero) that come within `reach` of the bounding box of its vertices, and `reach`, an upper bound of
the answer, sinks as one vertex of a cell is compared with all features of its cell.

All arithmetic is about the points of a grid of 2**103 units that `exactmesh.geometry.fixed_point` makes of the points;
a distance between those is off by less than 3 `error` units, and 4 of them are allowed for wherever it matters. A
difference D of two grid points is right to 2**-53 |D|. What is lost by cancellation, where a vertex is much nearer to a
segment than to its ends:

rounded   With w = p - a, d = b - a, the place t of the foot, from 0 to 1, is off by at most 8 * 2**-53 |w|/|d|, and
          |w - t d| grows by at most |d| for each unit of t: within 2**-48 (|w| + |d|) of the distance, with roundings.
refined   Where this is not small beside the distance, r = w - t d is computed for the same t with twice the digits
          (sums and products with their rounding errors): within 2**-51 |r| + 2**-99 (|w| + |d|). Then t is set right by
          r . d / |d|^2, kept in [0, 1], which moves r by at most 2**-49 |w|. The distance is within
          2**-48 |r| + 2**-97 (|w| + |d|).

So the search is as sharp for features of 2**-90 of the extent as for those of the size of the extent. Cells that are
smaller than that, with what comes near them, are searched for themselves: on a grid of their own around them, which the
features are cut to exactly.

`SLACK` is for others, who compare rounded distances of points in [-1, 1] within 2**-52 (`unit_floats`): such a distance
is off by less than half of it, by the argument for `rounded`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from exactmesh.geometry.decisions import note
from exactmesh.geometry.fixed_point import FixedPoints, Floats, Ints, stretches
from exactmesh.geometry.point import Point

Bools = NDArray[np.bool_]
Vectors = tuple[Floats, Floats]

SLACK = 2.0**-44
# Cells of at most this many vertices are compared with all their features.
_LEAF = 8
_ROUNDED, _REFINED, _RELATIVE = 2.0**-48, 2.0**-97, 2.0**-48
_NOT_SMALL = 16.0
# A rounded distance is good enough when its error is this small beside it.
_SHARP = 2.0**-20
# Cells with more features than this are searched for themselves once they and the reach are such a part of the extent.
_FEW, _TINY = 16, 2.0**-80
_DEEPEST = 64
_SPLITTER = 2.0**27 + 1
_LEAST_REACH, _FARTHEST = 1e-280, 1e200


def nearest_candidates(points: Sequence[Point], features: Sequence[tuple[int, int]] | Ints, blur: mpq | None = None
                       ) -> list[tuple[int, int]]:
    """Return pairs (vertex, feature index), among them all pairs at the least distance between a vertex and a
    feature that does not contain it; nearest first as far as floats can tell. Empty when there is no such pair.

    `features` are pairs of indices into `points`; a pair (v, v) is the point v. Coordinates may be off by `blur`, a
    length: the result is then right for whatever they stand for. Expected O((n + m) log n) for features that are not
    crowded on every scale; always finite and complete.
    """
    if not points or not len(features):
        return []
    ends = np.asarray(features, dtype=np.int64)
    problem = _Problem(points, np.arange(len(points)), ends, ends, np.arange(len(ends)))
    search = _Search(problem, blur or mpq(0), np.inf, _DEEPEST if blur else 0)
    search.run()
    pairs = search.pairs()
    note("least distance", search.compared, len(pairs))
    return pairs


@dataclass(frozen=True, slots=True)
class _Problem:
    """Vertices, which are the first of `points`, with their numbers; features with the `places` of their ends among the
    points, the numbers of the vertices at their ends, wherever these are, and their own numbers."""

    points: Sequence[Point]
    label: Ints
    places: Ints
    ends: Ints
    number: Ints


@dataclass(frozen=True, slots=True)
class _Cells:
    """Cells hold the vertices order[start:end]. Their boxes, `low` to `high`, are relative to the vertex `middle`."""

    order: Ints
    start: Ints
    end: Ints
    middle: Ints
    low: Vectors
    high: Vectors

    def extent(self) -> Floats:
        """Return the longer sides of the boxes."""
        return np.maximum(self.high[0] - self.low[0], self.high[1] - self.low[1])


class _Search:
    """One problem; lengths are in units of its own grid. `found` has lower bounds of distances, vertices, features."""

    def __init__(self, problem: _Problem, blur: mpq, reach: float, depth: int) -> None:
        self.problem = problem
        self.depth = depth
        self.columns = FixedPoints(problem.points)
        self.off = 4 * (self.columns.error + float(blur / self.columns.unit))
        self.tiny = _TINY * max((float(column.max()) for column in self.columns.rounded()), default=0.0)
        self.a, self.b = problem.places.T
        # By feature, so that what is looked at together lies together: the ends, and the vectors between them.
        self.ends = tuple(self._columns(place) for place in (self.a, self.b))
        self.along = self.columns.differences(self.a, self.b)
        self.reach = reach
        self.compared = 0
        self.found: list[tuple[Floats, Ints, Ints]] = []

    def run(self) -> None:
        """Search all cells."""
        real = self.problem.ends[:, 0] != self.problem.ends[:, 1]
        if self.problem.places is self.problem.ends and real.any():
            # The two ends of an edge are a vertex-vertex pair, so an edge's length bounds the answer.
            length = np.hypot(*self.along)[real]
            self.reach = float(length.min()) * (1 + _RELATIVE) + self.off
        count = len(self.problem.label)
        cells = self._cells(np.arange(count), np.array([0]), np.array([count]))
        cell, feature = np.zeros(len(self.a), np.int64), np.arange(len(self.a))
        while cells.start.size:
            # The reach matters where it is not small beside the cells.
            close = (cells.extent() <= _NOT_SMALL * self.reach)[cell]
            self._compare(cells.middle[cell[close]], feature[close], keep=False)
            crowded = self._are_crowded(cells, cell)
            done = self._zoom(cells, crowded, cell, feature)
            size = cells.end - cells.start
            # A crowded cell is halved until each part is tiny, if it takes single vertices.
            leaf = (size <= _LEAF) & ~done & ~(crowded & (size > 1))
            self._compare_leaves(cells, leaf, cell, feature)
            done |= leaf
            at_end = done[cell]
            renumbered = np.cumsum(~done) - 1
            cells = self._split(cells, ~done)
            cell, feature = self._descend(cells, renumbered[cell[~at_end]], feature[~at_end])

    def pairs(self) -> list[tuple[int, int]]:
        """Return the pairs found that may be nearest."""
        distance, vertex, feature = self._near()
        order = np.lexsort((feature, vertex, distance))
        return list(zip(vertex[order].tolist(), feature[order].tolist(), strict=True))

    def _near(self) -> tuple[Floats, Ints, Ints]:
        if not self.found:
            return np.empty(0), np.empty(0, np.int64), np.empty(0, np.int64)
        distance, vertex, feature = (np.concatenate(column) for column in zip(*self.found, strict=True))
        near = distance <= self.reach
        return distance[near], vertex[near], feature[near]

    # --- cells ---

    def _cells(self, order: Ints, start: Ints, end: Ints) -> _Cells:
        """Return cells that follow each other in `order` and are not empty."""
        middle = order[(start + end) // 2]
        if not start.size:
            return _Cells(order, start, end, middle, (np.empty(0),) * 2, (np.empty(0),) * 2)
        x, y = self.columns.differences(np.repeat(middle, end - start), order)
        return _Cells(order, start, end, middle,
                      (np.minimum.reduceat(x, start), np.minimum.reduceat(y, start)),
                      (np.maximum.reduceat(x, start), np.maximum.reduceat(y, start)))

    def _split(self, cells: _Cells, chosen: Bools) -> _Cells:
        """Halve the chosen cells, each across its longer extent."""
        start, size = cells.start[chosen], (cells.end - cells.start)[chosen]
        bounds = np.concatenate(([0], np.cumsum(size)))
        owner = np.repeat(np.arange(len(size)), size)
        order = cells.order[np.arange(bounds[-1]) - np.repeat(bounds[:-1] - start, size)]
        x, y = self.columns.differences(np.repeat(cells.middle[chosen], size), order)
        wide = (cells.high[0] - cells.low[0] >= cells.high[1] - cells.low[1])[chosen]
        order = order[np.lexsort((np.where(wide[owner], x, y), owner))]
        middle = bounds[:-1] + size // 2
        return self._cells(order, np.column_stack((bounds[:-1], middle)).ravel(),
                           np.column_stack((middle, bounds[1:])).ravel())

    def _descend(self, cells: _Cells, parent: Ints, feature: Ints) -> tuple[Ints, Ints]:
        """Hand each feature down to those of the two children of its cell that it comes near."""
        kept = [(parent[:0], feature[:0])]
        for side in (0, 1):
            for part in stretches(len(feature)):
                child = 2 * parent[part] + side
                near = self._is_near(cells, child, feature[part])
                kept.append((child[near], feature[part][near]))
        return np.concatenate([c for c, _ in kept]), np.concatenate([f for _, f in kept])

    def _is_near(self, cells: _Cells, cell: Ints, feature: Ints) -> Bools:
        """Return whether the feature may come within reach of the box: no axis of three separates them."""
        # Finite, so that it may be multiplied by a length of 0.
        reach = min(self.reach, _FARTHEST) + self.off
        centre = [column[cell] for column in self._columns(cells.middle)]
        start, end = (_differences(centre, [column[feature] for column in ends]) for ends in self.ends)
        near: Bools = np.ones(len(cell), np.bool_)
        for axis in (0, 1):
            high, low = cells.high[axis][cell] + reach, cells.low[axis][cell] - reach
            least, most = np.minimum(start[axis], end[axis]), np.maximum(start[axis], end[axis])
            near &= least - high <= _RELATIVE * (np.abs(least) + np.abs(high))
            near &= low - most <= _RELATIVE * (np.abs(most) + np.abs(low))
        some = np.flatnonzero(near)
        cell, feature = cell[some], feature[some]
        dx, dy = (column[feature] for column in self.along)
        mx, my = (((cells.low[axis] + cells.high[axis]) / 2)[cell] for axis in (0, 1))
        hx, hy = (((cells.high[axis] - cells.low[axis]) / 2)[cell] for axis in (0, 1))
        limit = (np.abs(dx) * hy + np.abs(dy) * hx + reach * np.hypot(dx, dy)) * (1 + _RELATIVE)
        beside, off = _beside(dx, dy, mx, my, -start[0][some], -start[1][some])
        near[some] = beside - off <= limit
        unsure = np.flatnonzero((beside - off <= limit) & (beside + off > limit))
        if unsure.size:
            rx, ry, error = self._refined(cells.middle[cell[unsure]], feature[unsure])
            dx, dy = dx[unsure], dy[unsure]
            beside, off = _beside(dx, dy, mx[unsure], my[unsure], rx, ry)
            off += error * (np.abs(dx) + np.abs(dy))
            near[some[unsure]] = beside - off <= limit[unsure]
        return near

    def _columns(self, places: Ints) -> list[Floats]:
        """Return the columns of some points."""
        c = self.columns
        return [column[places] for column in (c.x_high, c.x_low, c.y_high, c.y_low)]

    # --- distances ---

    def _compare(self, vertex: Ints, feature: Ints, keep: bool = True) -> None:
        """Take the distances of pairs into account; `keep` those that may be nearest."""
        for part in stretches(len(vertex)):
            self._compare_stretch(vertex[part], feature[part], keep)

    def _compare_stretch(self, vertex: Ints, feature: Ints, keep: bool) -> None:
        problem, columns = self.problem, self.columns
        free = (problem.ends[feature] != problem.label[vertex][:, None]).all(axis=1)
        vertex, feature = vertex[free], feature[free]
        self.compared += len(vertex)
        wx, wy = columns.differences(self.a[feature], vertex)
        dx, dy = (column[feature] for column in self.along)
        t = _foot(wx, wy, dx, dy)
        distance = np.hypot(wx - t * dx, wy - t * dy)
        off = _ROUNDED * (np.abs(wx) + np.abs(wy) + np.abs(dx) + np.abs(dy))
        blunt = np.flatnonzero((off > _SHARP * distance) & (distance - off <= self.reach + self.off))
        if blunt.size:
            rx, ry, error = self._refined(vertex[blunt], feature[blunt])
            distance[blunt] = np.hypot(rx, ry)
            off[blunt] = error + _RELATIVE * distance[blunt]
        if distance.size:
            self.reach = min(self.reach, float((distance + off).min()) * (1 + _RELATIVE) + self.off)
        if keep:
            low = distance - off - self.off
            near = low <= self.reach
            self.found.append((low[near], problem.label[vertex[near]], problem.number[feature[near]]))

    def _compare_leaves(self, cells: _Cells, leaf: Bools, cell: Ints, feature: Ints) -> None:
        """Compare all vertices of the leaves, which are few in each, with all their features."""
        at_leaf = leaf[cell]
        cell, feature = cell[at_leaf], feature[at_leaf]
        for offset in range(_LEAF):
            inside = (cells.end - cells.start)[cell] > offset
            self._compare(cells.order[cells.start[cell[inside]] + offset], feature[inside])

    def _refined(self, vertex: Ints, feature: Ints) -> tuple[Floats, Floats, Floats]:
        """Return the vectors to vertices from the nearest points of features, and how far they may be off, besides a
        part of 2**-49 of their length."""
        a, b = self.a[feature], self.b[feature]
        w, d = self._pairs(a, vertex), self._pairs(a, b)
        dx, dy = d[0][0], d[1][0]
        t = _foot(w[0][0], w[1][0], dx, dy)
        rx, ry = (_less_multiple(*w[axis], t, *d[axis]) for axis in (0, 1))
        squared = dx * dx + dy * dy
        more = np.divide(rx * dx + ry * dy, squared, out=np.zeros_like(t), where=squared > 0)
        more = np.clip(more, -t, 1 - t)
        size = np.abs(w[0][0]) + np.abs(w[1][0]) + np.abs(dx) + np.abs(dy)
        return rx - more * dx, ry - more * dy, _REFINED * size

    def _pairs(self, i: Ints, j: Ints) -> tuple[Vectors, Vectors]:
        """Return the vectors from the points i to j, each coordinate as a float and what it lacks, exactly."""
        c = self.columns
        return (_two_sum(c.x_high[j] - c.x_high[i], c.x_low[j] - c.x_low[i]),
                _two_sum(c.y_high[j] - c.y_high[i], c.y_low[j] - c.y_low[i]))

    # --- cells that are too small for the grid ---

    def _are_crowded(self, cells: _Cells, cell: Ints) -> Bools:
        """Return which cells have many features, so near that the grid may be too coarse for them."""
        if self.depth >= _DEEPEST or not self.reach < self.tiny:
            return np.zeros(len(cells.start), np.bool_)
        result: Bools = np.bincount(cell, minlength=len(cells.start)) > _FEW
        return result

    def _zoom(self, cells: _Cells, crowded: Bools, cell: Ints, feature: Ints) -> Bools:
        """Search crowded cells for themselves that are tiny, with all that is near them; return which ones."""
        chosen: Bools = crowded & (cells.extent() < self.tiny)
        some = np.flatnonzero(chosen)
        inside = np.flatnonzero(chosen[cell])
        inside = inside[np.argsort(cell[inside], kind="stable")]
        bounds = np.searchsorted(cell[inside], np.append(some, len(chosen)))
        for place, number in enumerate(some.tolist()):
            vertices = cells.order[cells.start[number] : cells.end[number]]
            self._search_around(vertices, feature[inside[bounds[place] : bounds[place + 1]]])
        return chosen

    def _search_around(self, vertices: Ints, feature: Ints) -> None:
        """Search the given vertices and features, cut to what may be within reach, on a grid of their own."""
        problem = self.problem
        points = [problem.points[v] for v in vertices.tolist()]
        margin = 2 * mpq(max(self.reach + self.off, _LEAST_REACH)) * self.columns.unit
        low = Point(min(p.x for p in points) - margin, min(p.y for p in points) - margin)
        high = Point(max(p.x for p in points) + margin, max(p.y for p in points) + margin)
        kept, places = [], []
        for f, a, b in zip(feature.tolist(), self.a[feature].tolist(), self.b[feature].tolist(), strict=True):
            part = _cut(problem.points[a], problem.points[b], low, high)
            if part is not None:
                kept.append(f)
                places.append((len(points), len(points) + 1))
                points += part
        if not kept:
            return
        inner = _Search(_Problem(points, problem.label[vertices], np.array(places), problem.ends[kept],
                                 problem.number[kept]), mpq(0), np.inf, self.depth + 1)
        ratio = float(inner.columns.unit / self.columns.unit)
        inner.reach = self.reach / ratio
        inner.run()
        self.compared += inner.compared
        self.reach = min(self.reach, max(inner.reach * ratio, _LEAST_REACH))
        distance, vertex, number = inner._near()
        self.found.append((distance * ratio, vertex, number))


def _differences(origin: Sequence[Floats], target: Sequence[Floats]) -> Vectors:
    """Return the vectors from points to others, given by their columns, as `FixedPoints.differences` does."""
    x_high, x_low, y_high, y_low = origin
    return (target[0] - x_high) + (target[1] - x_low), (target[2] - y_high) + (target[3] - y_low)


def _foot(wx: Floats, wy: Floats, dx: Floats, dy: Floats) -> Floats:
    """Return about where on the segment from 0 to d, from 0 to 1, w is nearest."""
    squared = dx * dx + dy * dy
    along = np.divide(wx * dx + wy * dy, squared, out=np.zeros_like(wx), where=squared > 0)
    return np.clip(along, 0.0, 1.0)


def _beside(dx: Floats, dy: Floats, mx: Floats, my: Floats, rx: Floats, ry: Floats) -> Vectors:
    """Return |d x (m + r)| and how much it may be off, with each of the vectors right to 2**-50 of its length."""
    value = np.abs(dx * (my + ry) - dy * (mx + rx))
    return value, _RELATIVE * (np.abs(dx) * (np.abs(my) + np.abs(ry)) + np.abs(dy) * (np.abs(mx) + np.abs(rx)))


def _two_sum(a: Floats, b: Floats) -> Vectors:
    """Return a + b rounded, and what is lacking, exactly (Knuth)."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _two_product(a: Floats, b: Floats) -> Vectors:
    """Return a b rounded, and what is lacking, exactly (Dekker)."""
    product = a * b
    scaled = _SPLITTER * a
    a_high = scaled - (scaled - a)
    scaled = _SPLITTER * b
    b_high = scaled - (scaled - b)
    a_low, b_low = a - a_high, b - b_high
    return product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


def _less_multiple(w: Floats, w_low: Floats, t: Floats, d: Floats, d_low: Floats) -> Floats:
    """Return (w + w_low) - t (d + d_low), rounded as if with twice the digits."""
    product, lacking = _two_product(t, d)
    total, low = _two_sum(w, -product)
    return total + (low + ((w_low - lacking) - t * d_low))


def _cut(a: Point, b: Point, low: Point, high: Point) -> tuple[Point, Point] | None:
    """Return the part of the segment a b in the box from `low` to `high`, exactly; None when they do not meet."""
    first, last = mpq(0), mpq(1)
    for at, to, least, most in ((a.x, b.x, low.x, high.x), (a.y, b.y, low.y, high.y)):
        step = to - at
        if step == 0:
            if not least <= at <= most:
                return None
            continue
        enter, leave = sorted(((least - at) / step, (most - at) / step))
        first, last = max(first, enter), min(last, leave)
    if first > last:
        return None
    dx, dy = b.x - a.x, b.y - a.y
    return Point(a.x + first * dx, a.y + first * dy), Point(a.x + last * dx, a.y + last * dy)
