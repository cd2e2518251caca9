"""All faces of a mesh at once, in arrays: which are triangles, their sides, and the least feature size of a face.

An entry is one vertex of one face's cycle; the side at an entry leads from its vertex to the next one of the cycle.
What is decided here is what `exactmesh.measure.face_feature` decides for one face, which has the last word on every
face that is no triangle and on every face that may have the least feature size.

Lengths are enclosed, not rounded. With D the computed difference of two points (see `exactmesh.geometry.fixed_point`),
a length is within 2**-50 |D| + 2 `error` of |D|. For the distance of p from the segment a b, with w = p - a and
d = b - a: the place t of the nearest point, from 0 to 1, is computed within 8 * 2**-53 |w|/|d|, and |w - t d| grows by
at most |d| for each unit of t; with the roundings of w - t d, the distance is within 2**-48 (|w| + |d|) + 8 `error`.

A height is the doubled area over the longest side. The area's bound is twice that of a determinant (given there), with
P and S as there: 2**-49 P + 4 `error` S + 8 `error`**2. Of its 16 * 2**-53 P the determinant takes 4.01, the length at
most 8, for P is no less than the area; the sums with the bound and with 2 `error`, and the division, one each.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from exactmesh.geometry.decisions import note
from exactmesh.geometry.fixed_point import FixedPoints, Floats, Ints, stretches
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.planar.cycles import Cycle

Bools = NDArray[np.bool_]
_LENGTH = 2.0**-50
_DISTANCE = 2.0**-48
_AREA = 2.0**-49
# Numbers below this need half the memory.
_MANY = 2**31 - 1


@dataclass(frozen=True, slots=True)
class Sides:
    """The directed edges of all faces: each distinct one by the entry where it is met first, in the order of entries.

    `first` are the entries of distinct edges, `repeated` those of faces that have an edge of an earlier face, with
    `owner` the entry where that one has it. An edge is looked for by its key, from * count + to of the vertices.
    """

    first: Ints
    repeated: Ints
    owner: Ints
    _sorted_keys: Ints
    _sorted_first: Ints

    def find(self, keys: Ints) -> Ints:
        """Return the entry where each of the keys is met first, -1 for a key that no edge has."""
        if not self._sorted_keys.size:
            return np.full(len(keys), -1)
        found = np.empty(len(keys), np.int64)
        for part in stretches(len(keys)):
            place = np.minimum(np.searchsorted(self._sorted_keys, keys[part]), len(self._sorted_keys) - 1)
            found[part] = np.where(self._sorted_keys[place] == keys[part], self._sorted_first[place], -1)
        return found


class MeshFaces:
    """The faces of a mesh: `vertex[entry]`, `face[entry]`, and `start[face]`, its first entry, one more at the end."""

    __slots__ = ("before", "columns", "cycles", "face", "following", "start", "turn",
                 "vertex")

    def __init__(self, columns: FixedPoints, cycles: Sequence[Cycle]) -> None:
        """Arrange `cycles`, whose indices are those of points of `columns`."""
        self.columns = columns
        self.cycles = cycles
        size = np.fromiter(map(len, cycles), np.int64, len(cycles))
        self.start = np.concatenate(([0], np.cumsum(size)))
        count = int(self.start[-1])
        # Half the memory where it will do; a key, which is a product, needs all of it.
        number: Any = np.int32 if max(count, len(columns.points)) < _MANY else np.int64
        self.vertex = np.fromiter(chain.from_iterable(cycles), number, count)
        self.face = np.repeat(np.arange(len(cycles), dtype=number), size)
        real = np.flatnonzero(size)
        self.following, self.before = np.arange(1, count + 1, dtype=number), np.arange(-1, count - 1, dtype=number)
        self.following[self.start[real + 1] - 1] = self.start[real]
        self.before[self.start[real]] = self.start[real + 1] - 1
        v = self.vertex
        self.turn = np.concatenate([np.empty(0, np.int8), *(
            columns.orientations(v[self.before[part]], v[part], v[self.following[part]]) for part in stretches(count))])

    def not_triangles(self) -> list[tuple[int, NotTriangle]]:
        """Return the faces that are not counter-clockwise triangles, and why."""
        v, turn = self.vertex, self.turn
        straight = np.flatnonzero(turn == 0)
        ahead = self.columns.are_ahead(v[self.before[straight]], v[straight], v[self.following[straight]])
        # A corner counts for one, a place where the walk must not go for so many that no face makes up for it.
        count = np.bincount(self.face, turn > 0, len(self.cycles))
        wrong = np.concatenate((self.face[turn < 0], self.face[straight[~ahead]]))
        refused = np.unique(np.concatenate((wrong, np.flatnonzero(count != 3))))
        found = []
        for face in refused.tolist():
            reason = corners_of(self.columns.points, self.cycles[face])
            if not isinstance(reason, NotTriangle):
                raise AssertionError(f"floats refuse face {face}, which is a triangle")
            found.append((face, reason))
        return found

    def sides(self) -> Sides:
        """Return the directed edges of all faces."""
        key = self.key(self.vertex, self.vertex[self.following])
        order = np.argsort(key, kind="stable")
        in_order = key[order]
        del key
        is_first = np.ones(len(order), np.bool_)
        is_first[1:] = in_order[1:] != in_order[:-1]
        if is_first.all():
            none = np.empty(0, np.int64)
            return Sides(np.arange(len(order), dtype=self.face.dtype), none, none, in_order,
                         order.astype(self.face.dtype))
        met_first = order[is_first]
        owner = met_first[np.cumsum(is_first) - 1]
        again = self.face[owner] != self.face[order]
        entry = order[again]
        sort = np.argsort(entry)
        return Sides(np.sort(met_first), entry[sort], owner[again][sort], in_order[is_first], met_first)

    def key(self, first: Ints, last: Ints) -> Ints:
        """Return the keys of edges by their ends."""
        key: Ints = first.astype(np.int64)
        key *= len(self.columns.points)
        key += last
        return key

    def least_feature(self) -> tuple[mpq, int] | None:
        """Return the least squared feature size of a face and the first face that has it; None without faces.

        All faces are triangles (`not_triangles` is empty).
        """
        if not self.cycles:
            return None
        corners = self._corners()
        low, high = np.empty(len(corners)), np.empty(len(corners))
        for part in stretches(len(corners)):
            low[part], high[part] = self._heights(corners[part])
        self._lower_by_t_vertices(low, high)
        near = np.flatnonzero(low <= high.min())
        note("least face feature", len(low), len(near))
        return min((face_feature_squared(self.columns.points, self.cycles[face], self._places(face)), face)
                   for face in near.tolist())

    def _corners(self) -> Ints:
        """Return the entries of the three corners of each face."""
        return np.flatnonzero(self.turn > 0).reshape(-1, 3)

    def _places(self, face: int) -> list[int]:
        start, end = self.start[face : face + 2].tolist()
        return np.flatnonzero(self.turn[start:end] > 0).tolist()

    def _heights(self, corners: Ints) -> tuple[Floats, Floats]:
        """Return bounds of the least height of each face with the given entries as corners."""
        columns, e = self.columns, self.columns.error
        a, b, c = self.vertex[corners].T
        (abx, aby), (acx, acy), (bcx, bcy) = (columns.differences(a, b), columns.differences(a, c),
                                              columns.differences(b, c))
        area = np.abs(abx * acy - aby * acx)
        off = _AREA * (np.abs(abx * acy) + np.abs(aby * acx)) + 4 * e * (
            np.abs(abx) + np.abs(aby) + np.abs(acx) + np.abs(acy)) + 8 * e * e
        longest = np.maximum(np.maximum(np.hypot(abx, aby), np.hypot(acx, acy)), np.hypot(bcx, bcy))
        low = np.maximum(area - off, 0.0) / (longest + 2 * e)
        shortest = longest - 2 * e
        return low, np.divide(area + off, shortest, out=np.full(len(area), np.inf), where=shortest > 0)

    def _lower_by_t_vertices(self, low: Floats, high: Floats) -> None:
        """Lower the bounds of faces with T-vertices: to the distances of T-vertices from the two sides of the triangle
        that they are not on, and from the next T-vertex on their own.

        No other edge counts: one from a T-vertex to a corner leads to one of those sides, and one between corners is no
        shorter than a height.
        """
        columns, e = self.columns, self.columns.error
        v = self.vertex
        t = np.flatnonzero(self.turn == 0)
        between = t[self.turn[self.following[t]] == 0]
        length = np.hypot(*columns.differences(v[between], v[self.following[between]]))
        off = _LENGTH * length + 2 * e
        np.minimum.at(low, self.face[between], length - off)
        np.minimum.at(high, self.face[between], length + off)
        # The corners passed before an entry say which side it is on, three of them for each face before: 0 and 3 are
        # the side from the last to the first.
        passed = np.cumsum(self.turn > 0)[t]
        corners = self._corners()[self.face[t]]
        rows = np.arange(len(t))
        p, q, r = (v[corners[rows, (passed + k) % 3]] for k in (2, 0, 1))
        for a, b in ((q, r), (r, p)):
            near, far = self._distances(v[t], a, b)
            np.minimum.at(low, self.face[t], near)
            np.minimum.at(high, self.face[t], far)

    def _distances(self, p: Ints, a: Ints, b: Ints) -> tuple[Floats, Floats]:
        """Return bounds of the distance of the points p from the segments a b."""
        (wx, wy), (dx, dy) = self.columns.differences(a, p), self.columns.differences(a, b)
        # Either 1 at least, or both dx and dy are 0 and it does not matter what t is.
        squared = np.maximum(dx * dx + dy * dy, 1.0)
        t = np.clip((wx * dx + wy * dy) / squared, 0.0, 1.0)
        distance = np.hypot(wx - t * dx, wy - t * dy)
        off = _DISTANCE * (np.abs(wx) + np.abs(wy) + np.abs(dx) + np.abs(dy)) + 8 * self.columns.error
        return distance - off, distance + off
