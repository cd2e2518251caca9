"""Points as columns of fixed-point numbers: whole arrays of predicates, floats first, exact where floats cannot tell.

A coordinate x becomes the integer X = floor(x / unit) less that of the least x, 0 <= X < 2**103, where `unit` is a
power of two (1, or less than that many units would do). It is kept as two floats, X = high + low, high a multiple of
2**52 and 0 <= low < 2**52, both without rounding. The difference of two coordinates is then

    D = (high - high') + (low - low'),    rounded once: off by at most 2**-53 |D|,

and the true difference, in units, is off from D by less than `error`: 1, or 0 when no coordinate was rounded down. So a
difference keeps its 53 bits down to 2**-50 of the extent of all points, where a plain double has none left.

The bound of a determinant a b - c d of four such differences, and of a b + c d. With P = |a b| + |c d| and
S = |a| + |b| + |c| + |d|, all computed, the rounded value is off by at most

    4.01 * 2**-53 * P        (a rounding for each difference, product and the sum)
    + error * 1.01 * S + 2 * error**2        (the fixed point),

and `2**-50 * P + 2 * error * S + 4 * error**2` leaves room for the rounding of the bound itself. Nothing overflows
(2**210) and nothing underflows (a difference that is not 0 is at least 1). Without `error`, and with P < 2**53, all
numbers are whole and every step is exact: then the sign is right as it is, 0 included.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from math import frexp

import numpy as np
from gmpy2 import mpq, sign
from numpy.typing import NDArray

from exactmesh.geometry.decisions import note
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import is_ahead

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_BITS = 103
_LOW = 52
_EXACT = 2.0**53
_RELATIVE = 2.0**-50
# What is worked on at once: enough to be quick, few enough to be no burden on memory.
_CHUNK = 1 << 15


def stretches(count: int) -> Iterator[slice]:
    """Yield slices that make up `count` places, so that intermediate arrays stay small."""
    for start in range(0, count, _CHUNK):
        yield slice(start, min(start + _CHUNK, count))


class FixedPoints:
    """Columns of `points`. `unit` is the length of a unit; `error` bounds what a difference is off, in units."""

    __slots__ = ("error", "points", "unit", "x_high", "x_low", "y_high", "y_low")

    def __init__(self, points: Sequence[Point]) -> None:
        self.points = points
        xs, ys = [p.x for p in points], [p.y for p in points]
        bits, whole = _bits_of_unit(xs, ys)
        self.unit = mpq(2) ** -bits
        self.error = 0.0 if whole else 1.0
        self.x_high, self.x_low = _split(xs, bits)
        self.y_high, self.y_low = _split(ys, bits)

    def differences(self, i: Ints, j: Ints) -> tuple[Floats, Floats]:
        """Return the vectors from the points i to the points j, in units."""
        return ((self.x_high[j] - self.x_high[i]) + (self.x_low[j] - self.x_low[i]),
                (self.y_high[j] - self.y_high[i]) + (self.y_low[j] - self.y_low[i]))

    def rounded(self) -> tuple[Floats, Floats]:
        """Return both coordinates in units as plain floats, rounded once; points at one place stay so."""
        return self.x_high + self.x_low, self.y_high + self.y_low

    def orientations(self, i: Ints, j: Ints, k: Ints) -> NDArray[np.int8]:
        """Return `exactmesh.geometry.predicates.orientation` of the points i, j, k, elementwise."""
        found = np.empty(len(i), np.int8)
        for part in stretches(len(i)):
            at = i[part], j[part], k[part]
            (ax, ay), (bx, by) = self.differences(at[0], at[1]), self.differences(at[0], at[2])
            found[part] = self._signs(ax, by, -ay, bx, at, _turn, "orientation")
        return found

    def are_ahead(self, i: Ints, j: Ints, k: Ints) -> NDArray[np.bool_]:
        """Return `exactmesh.geometry.predicates.is_ahead` of the points i, j, k, elementwise."""
        found = np.empty(len(i), np.bool_)
        for part in stretches(len(i)):
            at = i[part], j[part], k[part]
            (ax, ay), (bx, by) = self.differences(at[0], at[1]), self.differences(at[1], at[2])
            found[part] = self._signs(ax, bx, ay, by, at, is_ahead, "ahead") > 0
        return found

    def _signs(self, a: Floats, b: Floats, c: Floats, d: Floats, at: tuple[Ints, Ints, Ints],
               exactly: Callable[[Point, Point, Point], int], what: str) -> NDArray[np.int8]:
        """Return the signs of a b + c d; `exactly` decides those that the bound does not."""
        first, second = a * b, c * d
        value = first + second
        products = np.abs(first) + np.abs(second)
        bound = _RELATIVE * products
        if self.error:
            bound += 2 * self.error * (np.abs(a) + np.abs(b) + np.abs(c) + np.abs(d)) + 4 * self.error**2
        else:
            bound[products < _EXACT] = -1.0
        signs = np.sign(value).astype(np.int8)
        open_ones = np.flatnonzero(np.abs(value) <= bound)
        note(what, len(value), len(open_ones))
        points = self.points
        for place, *corners in zip(open_ones.tolist(), *(v[open_ones].tolist() for v in at), strict=True):
            p, q, r = corners
            signs[place] = exactly(points[p], points[q], points[r])
        return signs

    def lexicographic(self) -> Ints:
        """Return the indices of the points in their order, by x and then y; equal points by index."""
        order = np.lexsort((self.y_low, self.y_high, self.x_low, self.x_high))
        if not self.error or len(order) < 2:
            return order
        # Rounding down keeps the order but for ties: those of x are settled exactly.
        high, low = self.x_high[order], self.x_low[order]
        starts = np.concatenate(([True], (high[1:] != high[:-1]) | (low[1:] != low[:-1])))
        bounds = np.append(np.flatnonzero(starts), len(order))
        for run in np.flatnonzero(np.diff(bounds) > 1).tolist():
            tied = order[bounds[run] : bounds[run + 1]]
            order[bounds[run] : bounds[run + 1]] = sorted(tied.tolist(), key=lambda v: (self.points[v], v))
        return order

    def coincident(self) -> list[tuple[int, int]]:
        """Return pairs (v, u) for every point v that an earlier one equals, u the first of them; rising in v."""
        if len(self.points) < 2:
            return []
        x, y = self.rounded()
        order = np.lexsort((y, x))
        same = np.flatnonzero((x[order[1:]] == x[order[:-1]]) & (y[order[1:]] == y[order[:-1]]))
        close = np.unique(np.concatenate((order[same], order[same + 1])))
        note("coincidence", len(self.points), len(close))
        first: dict[Point, int] = {}
        found = ((v, first.setdefault(self.points[v], v)) for v in close.tolist())
        return [(v, u) for v, u in found if u != v]


class TurnFilter:
    """The orientation of single triples of `columns`, for sweeps: two plain floats a point, then columns, then exact.

    The bound of the first step. In units of a power of two r above all coordinates (a grid that rounds them has
    a unit of at most 2**-99 r) a plain float is within 2**-53 + 2**-99 of its coordinate in [0, 1], so a difference is
    off by eta < 2**-51; with S the sum of the four absolute differences the determinant is off by at most
    eta * S + 2 * eta**2 + 3 * 2**-53 * S < 2**-49 * S for S >= 2**-49; and for smaller S it is, as computed, at most
    S**2 / 2 (1 + 2**-50) < 2**-49 * S, so that nothing is decided.
    """

    __slots__ = ("_bound", "_columns", "_far", "_x", "_y", "asked", "second", "third")

    def __init__(self, columns: FixedPoints) -> None:
        self._columns = columns
        rounded = columns.rounded()
        size = max(float(column.max(initial=0.0)) for column in rounded)
        self._bound = 2.0 ** (frexp(size)[1] - 49)
        # S is 4 `size` at most: beyond this there is no need to know it.
        self._far = 5 * size * self._bound
        self._x, self._y = (column.tolist() for column in rounded)
        self.asked = self.second = self.third = 0

    def orientation(self, i: int, j: int, k: int) -> int:
        """Return 1, -1 or 0 as `exactmesh.geometry.predicates.orientation` of the points i, j, k."""
        xs, ys = self._x, self._y
        x, y = xs[i], ys[i]
        a, b, c, d = xs[j] - x, ys[k] - y, ys[j] - y, xs[k] - x
        determinant = a * b - c * d
        self.asked += 1
        if determinant > self._far:
            return 1
        if determinant < -self._far:
            return -1
        return self._close(determinant, a, b, c, d) or self._closer(i, j, k)

    def count_below(self, edges: Sequence[int], left: Sequence[int], right: Sequence[int], v: int) -> int:
        """Return how many of some edges in order from below are below point v: those with `orientation` 1.

        `left` and `right` have the ends of all edges.
        """
        xs, ys, far = self._x, self._y, self._far
        px, py = xs[v], ys[v]
        start, end = 0, len(edges)
        while start < end:
            middle = (start + end) >> 1
            edge = edges[middle]
            i, j = left[edge], right[edge]
            x, y = xs[i], ys[i]
            a, b, c, d = xs[j] - x, py - y, ys[j] - y, px - x
            determinant = a * b - c * d
            self.asked += 1
            if determinant > far or (determinant >= -far and (
                    self._close(determinant, a, b, c, d) or self._closer(i, j, v)) > 0):
                start = middle + 1
            else:
                end = middle
        return start

    def _close(self, determinant: float, a: float, b: float, c: float, d: float) -> int:
        """Return the sign of a determinant that plain floats are sure of, else 0."""
        bound = self._bound * (abs(a) + abs(b) + abs(c) + abs(d))
        return (determinant > bound) - (determinant < -bound)

    def _closer(self, i: int, j: int, k: int) -> int:
        self.second += 1
        if i == j or j == k or k == i:
            return 0
        columns = self._columns
        xh, xl, yh, yl = columns.x_high, columns.x_low, columns.y_high, columns.y_low
        a, b = float((xh[j] - xh[i]) + (xl[j] - xl[i])), float((yh[k] - yh[i]) + (yl[k] - yl[i]))
        c, d = float((yh[j] - yh[i]) + (yl[j] - yl[i])), float((xh[k] - xh[i]) + (xl[k] - xl[i]))
        first, second = a * b, c * d
        determinant, products, error = first - second, abs(first) + abs(second), columns.error
        bound = _RELATIVE * products + 2 * error * (abs(a) + abs(b) + abs(c) + abs(d)) + 4 * error * error
        if abs(determinant) > bound or (error == 0 and products < _EXACT):
            return (determinant > 0) - (determinant < 0)
        self.third += 1
        points = columns.points
        return _turn(points[i], points[j], points[k])

    def note(self) -> None:
        """Add the counts since the last time to those of `exactmesh.geometry.decisions`."""
        note("sweep orientation", self.asked, self.third)
        self.asked = self.second = self.third = 0


def _turn(a: Point, b: Point, c: Point) -> int:
    """Return `exactmesh.geometry.predicates.orientation` of the points, without a single common divisor.

    Each difference is a numerator over the product of two denominators; the determinant is multiplied by all of them.
    """
    (ax, ay), (bx, by), (cx, cy) = a, b, c
    axd, ayd, bxd, byd, cxd, cyd = (ax.denominator, ay.denominator, bx.denominator, by.denominator, cx.denominator,
                                    cy.denominator)
    axn, ayn = ax.numerator, ay.numerator
    first = (bx.numerator * axd - axn * bxd) * (cy.numerator * ayd - ayn * cyd) * (byd * cxd)
    second = (by.numerator * ayd - ayn * byd) * (cx.numerator * axd - axn * cxd) * (bxd * cyd)
    return int(sign(first - second))


def _bits_of_unit(xs: Sequence[mpq], ys: Sequence[mpq]) -> tuple[int, bool]:
    """Return b for a unit of 2**-b, and whether all coordinates are whole numbers of units."""
    if not xs:
        return 0, True
    reach = max(max(xs) - min(xs), max(ys) - min(ys))
    # reach < 2**size
    size = reach.numerator.bit_length() - reach.denominator.bit_length() + 1 if reach else 0
    if size < _BITS and all(x.denominator == 1 for x in xs) and all(y.denominator == 1 for y in ys):
        return 0, True
    return _BITS - 1 - size, False


def _split(values: Sequence[mpq], bits: int) -> tuple[Floats, Floats]:
    """Return floor(v 2**bits) less the least of them, as a multiple of 2**52 and what is left."""
    high, low = np.empty(len(values)), np.empty(len(values))
    if not values:
        return high, low
    least = min(values)
    up, down = max(bits, 0), max(-bits, 0)
    origin = (least.numerator << up) // (least.denominator << down)
    rest = iter(values)
    for part in stretches(len(values)):
        whole = [((v.numerator << up) // (v.denominator << down) - origin).to_bytes(16, "little")
                 for v in islice(rest, part.stop - part.start)]
        words = np.frombuffer(b"".join(whole), "<u8").reshape(-1, 2)
        high[part] = ((words[:, 1] << np.uint64(64 - _LOW)) | (words[:, 0] >> np.uint64(_LOW))).astype(np.float64)
        low[part] = (words[:, 0] & np.uint64(2**_LOW - 1)).astype(np.float64)
    high *= 2.0**_LOW
    return high, low
