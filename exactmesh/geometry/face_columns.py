"""Faces in arrays: which cycles are counter-clockwise triangles, and balls for their feature sizes.

The definitions are those of `exactmesh.measure.face_feature`, for many cycles at once: floats decide what they can,
exact predicates the rest. Most faces have three vertices; those with T-vertices are looked at side by side.
"""

from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np

from exactmesh.geometry.balls import Balls, Bools, Ints, between, least
from exactmesh.geometry.columns import Columns, Rows
from exactmesh.geometry.decisions import note
from exactmesh.geometry.predicates import is_ahead

# Arrays of this many faces fit into the processor's cache.
CHUNK = 1 << 13


class FaceColumns:
    """Cycles of vertices: `triples` has those of the faces `short`, of three vertices; `rows` the others, `long`."""

    __slots__ = ("count", "long", "rows", "short", "triples")

    def __init__(self, cycles: Sequence[Sequence[int]]) -> None:
        size = np.fromiter(map(len, cycles), np.int64, len(cycles))
        self.count = len(cycles)
        self.short, self.long = np.flatnonzero(size == 3), np.flatnonzero(size != 3)
        if len(self.long):
            of_three: Sequence[Sequence[int]] = [cycle for cycle in cycles if len(cycle) == 3]
        else:
            of_three = cycles
        flat = np.fromiter(chain.from_iterable(of_three), np.int64, 3 * len(self.short))
        self.triples: Ints = flat.reshape(-1, 3)
        self.rows = Rows([cycles[i] for i in self.long.tolist()])

    def sides(self) -> tuple[Ints, Ints]:
        """Return the directed edges of all cycles as columns of first and of last ends, in no order."""
        place, begin = np.arange(len(self.rows.flat)), self.rows.start
        following = place + 1
        following[begin[1:][self.rows.size > 0] - 1] = begin[:-1][self.rows.size > 0]
        first = np.concatenate((self.triples.ravel(), self.rows.flat))
        last = np.concatenate((self.triples[:, (1, 2, 0)].ravel(), self.rows.flat[following]))
        return first, last


class Corners:
    """Which of the faces are counter-clockwise triangles, and the places of the corners in the long ones.

    `bad` lists the others, in order. `places[i]` are the places in the flat rows of the three corners of long face i.
    """

    __slots__ = ("bad", "places")

    def __init__(self, points: Columns, faces: FaceColumns) -> None:
        bad = [faces.short[start + np.flatnonzero(points.turns(*part.T) <= 0)]
               for start, part in chunks(faces.triples)]
        well, self.places = _long_corners(points, faces.rows)
        self.bad: Ints = np.sort(np.concatenate((*bad, faces.long[~well])))


def chunks(array: Ints) -> Iterator[tuple[int, Ints]]:
    """Yield stretches of an array with where they begin."""
    for start in range(0, len(array), CHUNK):
        yield start, array[start : start + CHUNK]


def _long_corners(points: Columns, rows: Rows) -> tuple[Bools, Ints]:
    """Return which rows are counter-clockwise triangles, and the places of their corners (of others, anything)."""
    flat, start, size = rows.flat, rows.start, rows.size
    places = np.zeros((len(size), 3), np.int64)
    some = np.flatnonzero(size > 0)
    place = np.arange(len(flat))
    before, after = place - 1, place + 1
    before[start[:-1][some]] = start[1:][some] - 1
    after[start[1:][some] - 1] = start[:-1][some]
    row = np.repeat(np.arange(len(size)), size)
    turn = points.turns(flat[before], flat, flat[after])
    corners = np.flatnonzero(turn > 0)
    well: Bools = np.bincount(row[corners], minlength=len(size)) == 3
    well[row[turn < 0]] = False
    straight = np.flatnonzero(turn == 0)
    ahead = points.vectors(flat[before[straight]], flat[straight]).dot(
        points.vectors(flat[straight], flat[after[straight]])).signs()
    for i, sure in zip(straight.tolist(), ahead.tolist(), strict=True):
        if sure < 0 or (sure == 0 and not is_ahead(
                points[flat[before[i]]], points[flat[i]], points[flat[after[i]]])):
            well[row[i]] = False
    note("ahead", len(straight), int((ahead == 0).sum()))
    places[well] = corners[well[row[corners]]].reshape(-1, 3)
    return well, places


def features_squared(points: Columns, faces: FaceColumns, corners: Corners) -> Iterator[tuple[Ints, Balls]]:
    """Yield the numbers of faces and balls for their squared feature sizes, chunk by chunk, each face once.

    Of a face that is no triangle the ball has no meaning.
    """
    for start, part in chunks(faces.triples):
        yield faces.short[start : start + CHUNK], points.heights_squared(*part.T)
    for start in range(0, len(faces.long), CHUNK):
        some = np.arange(start, min(start + CHUNK, len(faces.long)))
        some = some[(corners.places[some] != corners.places[some][:, (1, 2, 0)]).all(axis=1)]
        if some.size:
            yield faces.long[some], _long_features(points, faces.rows, corners.places[some], some)


def _long_features(points: Columns, rows: Rows, places: Ints, some: Ints) -> Balls:
    """Return the squared feature sizes of the given rows; `places` are those of their corners."""
    place, begin = rows.places(some)
    number = np.repeat(np.arange(len(some)), rows.size[some])
    following = place + 1
    following[begin[1:] - 1] = place[begin[:-1]]
    value = _by_row(points.distances_squared(rows.flat[place], rows.flat[following]), begin)
    i, j, k = places.T
    a, b, c = rows.flat[i], rows.flat[j], rows.flat[k]
    value = least(value, points.heights_squared(a, b, c))
    at = np.flatnonzero((place[:, None] != places[number]).all(axis=1))
    if not at.size:
        return value
    # A T-vertex lies behind corner i, j or k; the side from there to the next corner is its own.
    row, here = number[at], place[at]
    behind = np.where((here > i[row]) & (here < j[row]), 0, np.where((here > j[row]) & (here < k[row]), 1, 2))
    corner = np.stack((a, b, c))
    p, q, r = (corner[(behind + step) % 3, row] for step in (1, 2, 0))
    t = rows.flat[here]
    near = least(points.segment_distances_squared(t, p, q), points.segment_distances_squared(t, q, r))
    have = np.flatnonzero(np.bincount(row, minlength=len(some)))
    close = _by_row(near, np.searchsorted(row, np.append(have, len(some))))
    low, high = value.low(), value.high()
    low[have], high[have] = np.minimum(low[have], close.low()), np.minimum(high[have], close.high())
    return between(low, high)


def _by_row(values: Balls, begin: Ints) -> Balls:
    """Return the least ball of each stretch of the values; no stretch is empty."""
    return between(np.minimum.reduceat(values.low(), begin[:-1]), np.minimum.reduceat(values.high(), begin[:-1]))


def unpaired_sides(faces: FaceColumns, count: int) -> Ints | None:
    """Return the directed edges of all cycles whose twins are in no cycle, as sorted keys u * count + v.

    None when a directed edge is there twice. `count` is above all vertices.
    """
    first, last = faces.sides()
    key, twin = first * count, last * count
    key += last
    twin += first
    del first, last
    key.sort()
    if (key[1:] == key[:-1]).any():
        return None
    twin.sort()
    unpaired = [part[twin[np.minimum(np.searchsorted(twin, part), len(twin) - 1)] != part] for _, part in chunks(key)]
    return np.concatenate((key[:0], *unpaired))
