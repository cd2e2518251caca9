"""Points with their coordinates as columns of balls, and the predicates and measures of arrays of indices.

Points far from the origin, as seen from their own extent,
are moved near to it beforehand, exactly: everything here depends on differences of points only.
"""

from collections.abc import Iterable, Iterator, Sequence
from copy import copy
from itertools import chain
from typing import overload

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import Balls, Ints, ball_of, constant, greatest, joined
from exactmesh.geometry.decisions import note
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation

# Points this many times farther away than they are apart are moved.
_FAR = 16


class Columns(Sequence[Point]):
    """Points as a sequence, with the columns `x` and `y` of balls, up to one translation of all points."""

    __slots__ = ("_moved", "points", "x", "y")

    def __init__(self, points: Sequence[Point]) -> None:
        self.points = points
        (self.x, by_x), (self.y, by_y) = (_near_origin([p[axis] for p in points]) for axis in (0, 1))
        self._moved = by_x, by_y

    def extended(self, points: Sequence[Point]) -> "Columns":
        """Return the columns of these points and of further ones, without a second look at these."""
        more = copy(self)
        more.points = [*self.points, *points]
        by_x, by_y = self._moved
        more.x = joined(self.x, ball_of(*([p.x - by_x for p in points] if by_x else [p.x for p in points])))
        more.y = joined(self.y, ball_of(*([p.y - by_y for p in points] if by_y else [p.y for p in points])))
        return more

    @overload
    def __getitem__(self, index: int) -> Point: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Point]: ...
    def __getitem__(self, index: int | slice) -> Point | Sequence[Point]:
        return self.points[index]

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Point]:
        return iter(self.points)

    def vectors(self, a: Ints, b: Ints) -> "Vectors":
        """Return the vectors from the points a to the points b."""
        return Vectors(self.x[b] - self.x[a], self.y[b] - self.y[a])

    def doubled_areas(self, a: Ints, b: Ints, c: Ints) -> Balls:
        """Return twice the signed areas of the triangles a, b, c."""
        return self.vectors(a, b).cross(self.vectors(a, c))

    def turns(self, a: Ints, b: Ints, c: Ints) -> Ints:
        """Return 1, -1 or 0 as the points a, b, c turn left, right or not; decided exactly where floats cannot."""
        signs = self.doubled_areas(a, b, c).signs().astype(np.int64)
        open_places = np.flatnonzero(signs == 0)
        points = self.points
        for i in open_places.tolist():
            signs[i] = orientation(points[a[i]], points[b[i]], points[c[i]])
        note("turn", len(signs), len(open_places))
        return signs

    def distances_squared(self, a: Ints, b: Ints) -> Balls:
        """Return the squared distances of the points a and b."""
        return self.vectors(a, b).norm()

    def heights_squared(self, a: Ints, b: Ints, c: Ints) -> Balls:
        """Return the squared least heights of the triangles a, b, c."""
        ab, ac = self.vectors(a, b), self.vectors(a, c)
        longest = greatest(ab.norm(), ac.norm(), self.vectors(b, c).norm())
        return ab.cross(ac).squared() / longest

    def segment_distances_squared(self, p: Ints, a: Ints, b: Ints) -> Balls:
        """Return the squared distances of the points p from the segments a b; not decided where a = b."""
        # What p sticks out beyond an end, along the segment, and its height over the line, by Pythagoras.
        ab, ap = self.vectors(a, b), self.vectors(a, p)
        along, length_squared = ab.dot(ap), ab.norm()
        beyond = greatest(constant(0, along), -along, along - length_squared)
        return (ab.cross(ap).squared() + beyond.squared()) / length_squared


class Vectors:
    """Columns of vectors."""

    __slots__ = ("x", "y")

    def __init__(self, x: Balls, y: Balls) -> None:
        self.x, self.y = x, y

    def cross(self, other: "Vectors") -> Balls:
        """Return the cross products."""
        return self.x * other.y - self.y * other.x

    def dot(self, other: "Vectors") -> Balls:
        """Return the dot products."""
        return self.x * other.x + self.y * other.y

    def norm(self) -> Balls:
        """Return the squared lengths."""
        return self.x.squared() + self.y.squared()


def columns_of(points: Sequence[Point]) -> Columns:
    """Return the points with columns; as they are when they have them."""
    return points if isinstance(points, Columns) else Columns(points)


def indices(values: Iterable[int], count: int = -1) -> Ints:
    """Return numbers as an array."""
    return np.fromiter(values, dtype=np.int64, count=count)


class Rows:
    """Rows of indices of different lengths: row r is `flat[start[r]:start[r + 1]]`."""

    __slots__ = ("flat", "size", "start")

    def __init__(self, rows: Sequence[Sequence[int]]) -> None:
        self.size = indices(map(len, rows), len(rows))
        self.start = np.concatenate((np.zeros(1, np.int64), np.cumsum(self.size)))
        self.flat = indices(chain.from_iterable(rows), int(self.start[-1]))

    def __len__(self) -> int:
        return len(self.size)

    def places(self, rows: Ints) -> tuple[Ints, Ints]:
        """Return the places in `flat` of the given rows, one row after the other, and where each of them begins."""
        size = self.size[rows]
        start = np.concatenate((np.zeros(1, np.int64), np.cumsum(size)))
        return np.arange(start[-1]) + np.repeat(self.start[rows] - start[:-1], size), start


def column_of(values: Sequence[mpq]) -> Balls:
    """Return balls for rationals, moved by one whole number where they are far away."""
    return _near_origin(values)[0]


def _near_origin(values: Sequence[mpq]) -> tuple[Balls, mpq]:
    """Return balls for rationals less a whole number, and that number, 0 unless they are far away."""
    column = ball_of(*values)
    if len(column):
        low, high = column.mid.min(), column.mid.max()
        with np.errstate(all="ignore"):  # beyond the range of floats the difference is no number
            reach = high - low
        if not np.isfinite(reach) or max(abs(low), abs(high)) > _FAR * reach:
            centre = (min(values) + max(values)) / 2
            whole = mpq(centre.numerator // centre.denominator)
            return ball_of(*(value - whole for value in values)), whole
    return column, mpq(0)
