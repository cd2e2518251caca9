"""Vertex-feature pairs that may realise the minimum feature size, found with floats and missing none.

A k-d tree over the vertices is walked level by level in arrays: a cell keeps the features (segments, or points as
segments of length zero) that come within `reach` of the bounding box of its vertices, and `reach`, an upper bound of
the answer, sinks as one vertex of each cell is compared with all features of its cell. Only distances are rounded;
every comparison leaves `SLACK` for that, so the result contains every pair at the least distance.

Why SLACK suffices: coordinates lie in [-1, 1] within 2**-52 (`unit_floats`). The rounded foot of a perpendicular is
off along the segment by s <= c 2**-52 (|p| + length) / length, and never by more than the length. For a point at
distance d the distance then changes by at most s <= 3 c 2**-52 when d <= length, else by s**2 / (2 d) <= 2 c 2**-52;
c < 16 counts the roundings. 2**-44 is more than twice that.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from exactmesh.geometry.filtered import unit_floats
from exactmesh.geometry.point import Point

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
SLACK = 2.0**-44
# Cells of at most this many vertices are compared with all their features.
_LEAF = 4


def nearest_candidates(points: Sequence[Point], features: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return pairs (vertex, feature index), among them all pairs at the least distance between a vertex and a
    feature that does not contain it; nearest first as far as floats can tell. Empty when there is no such pair.

    `features` are pairs of indices into `points`; a pair (v, v) is the point v. Expected O((n + m) log n) for
    features that are not crowded on every scale; always finite and complete.
    """
    if not points or not features:
        return []
    x, y, _ = unit_floats(points)
    return _Search(np.array([x, y]).T, np.array(features, dtype=np.int64)).run()


class _Search:
    """The level being worked on: cells hold the vertices `order[start:end]` and the `feature`s with that `cell`."""

    def __init__(self, xy: Floats, ends: Ints) -> None:
        self.xy = xy
        self.ends = ends
        self.a, self.b = xy[ends[:, 0]], xy[ends[:, 1]]
        real = ends[:, 0] != ends[:, 1]
        # The two ends of an edge are a vertex-vertex pair, so an edge's length bounds the answer.
        lengths = np.hypot(*(self.b - self.a)[real].T)
        self.reach = float(lengths.min()) if lengths.size else np.inf
        self.found: list[tuple[Floats, Ints, Ints]] = []

    def run(self) -> list[tuple[int, int]]:
        order = np.arange(len(self.xy))
        start, end = np.array([0]), np.array([len(order)])
        cell, feature = np.zeros(len(self.ends), np.int64), np.arange(len(self.ends))
        while start.size:
            self._lower_reach(order, start, end, cell, feature)
            leaf = end - start <= _LEAF
            at_leaf = leaf[cell]
            self._compare_leaves(order, start, end, cell[at_leaf], feature[at_leaf])
            order, start, end = _split(self.xy, order, start[~leaf], end[~leaf])
            renumbered = np.cumsum(~leaf) - 1
            cell, feature = self._descend(order, start, renumbered[cell[~at_leaf]], feature[~at_leaf])
        return self._sorted()

    def _lower_reach(self, order: Ints, start: Ints, end: Ints, cell: Ints, feature: Ints) -> None:
        """Compare the middle vertex of each cell with all features of the cell."""
        vertex = order[(start + end) // 2][cell]
        distance = self._distances(vertex, feature)
        if distance.size:
            self.reach = min(self.reach, float(distance.min()))

    def _compare_leaves(self, order: Ints, start: Ints, end: Ints, cell: Ints, feature: Ints) -> None:
        for offset in range(_LEAF):
            inside = start[cell] + offset < end[cell]
            vertex, other = order[start[cell[inside]] + offset], feature[inside]
            distance = self._distances(vertex, other)
            if distance.size:
                self.reach = min(self.reach, float(distance.min()))
            near = np.isfinite(distance) & (distance <= self.reach + SLACK)
            self.found.append((distance[near], vertex[near], other[near]))

    def _distances(self, vertex: Ints, feature: Ints) -> Floats:
        """Return rounded distances, infinite where the feature contains the vertex."""
        p, a = self.xy[vertex], self.a[feature]
        d = self.b[feature] - a
        length_squared = (d * d).sum(axis=1)
        along = ((p - a) * d).sum(axis=1)
        t = np.clip(np.divide(along, length_squared, out=np.zeros_like(along), where=length_squared > 0), 0, 1)
        distance: Floats = np.hypot(*(p - a - t[:, None] * d).T)
        contains = (self.ends[feature] == vertex[:, None]).any(axis=1)
        distance[contains] = np.inf
        return distance

    def _descend(self, order: Ints, start: Ints, cell: Ints, feature: Ints
                 ) -> tuple[Ints, Ints]:
        """Hand each feature down to those of the two children of its cell that it comes near."""
        if not start.size:
            return cell[:0], feature[:0]
        low = np.minimum.reduceat(self.xy[order], start)
        high = np.maximum.reduceat(self.xy[order], start)
        kept = []
        for side in (0, 1):
            child = 2 * cell + side
            near = self._is_near(low[child], high[child], feature)
            kept.append((child[near], feature[near]))
        return np.concatenate([c for c, _ in kept]), np.concatenate([f for _, f in kept])

    def _is_near(self, low: Floats, high: Floats, feature: Ints) -> NDArray[np.bool_]:
        """Return whether the feature may come within reach of the box: no axis of three separates them."""
        a, b = self.a[feature], self.b[feature]
        reach = self.reach + SLACK
        near = ((np.minimum(a, b) <= high + reach) & (np.maximum(a, b) >= low - reach)).all(axis=1)
        d = b - a
        middle, half = (low + high) / 2 - a, (high - low) / 2
        beside = np.abs(d[:, 0] * middle[:, 1] - d[:, 1] * middle[:, 0])
        width = np.abs(d[:, 0]) * half[:, 1] + np.abs(d[:, 1]) * half[:, 0]
        result: NDArray[np.bool_] = near & (beside <= width + reach * np.hypot(d[:, 0], d[:, 1]) + SLACK)
        return result

    def _sorted(self) -> list[tuple[int, int]]:
        distance, vertex, feature = (np.concatenate(column) for column in zip(*self.found, strict=True))
        near = np.flatnonzero(distance <= self.reach + SLACK)
        near = near[np.lexsort((feature[near], vertex[near], distance[near]))]
        return list(zip(vertex[near].tolist(), feature[near].tolist(), strict=True))


def _split(xy: Floats, order: Ints, start: Ints, end: Ints) -> tuple[Ints, Ints, Ints]:
    """Halve each cell [start, end) across its longer extent; return the new order, starts and ends."""
    if not start.size:
        return order, start, end
    size = end - start
    bounds = np.concatenate(([0], np.cumsum(size)))
    owner = np.repeat(np.arange(len(size)), size)
    order = order[np.arange(bounds[-1]) - np.repeat(bounds[:-1] - start, size)]
    here = xy[order]
    extent = np.maximum.reduceat(here, bounds[:-1]) - np.minimum.reduceat(here, bounds[:-1])
    key = np.where((extent[:, 0] >= extent[:, 1])[owner], here[:, 0], here[:, 1])
    order = order[np.lexsort((key, owner))]
    middle = bounds[:-1] + size // 2
    starts = np.column_stack((bounds[:-1], middle)).ravel()
    ends = np.column_stack((middle, bounds[1:])).ravel()
    return order, starts, ends
