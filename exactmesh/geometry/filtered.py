"""Orientation of indexed points: a float filter with a proven bound in front of the exact predicate.

Coordinates are moved and scaled by a power of two to |x|, |y| <= 1 exactly, then rounded; each is then off by at most
2**-52. With d the four rounded differences, S the sum of their absolute values and eta = 3 * 2**-52 the error of a
difference, the rounded determinant is off by at most

    eta * S + 2 * eta**2        (the differences)
    + 3 * 2**-53 * S            (two products of numbers <= 2, one subtraction)  <=  2**-49 * S

unless S < 6 * 2**-52, and there |determinant| <= S**2 / 2 < 2**-49 * S. So a determinant beyond 2**-49 * S has the
right sign; anything else is decided exactly.
"""

from collections.abc import Sequence

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation

_BOUND = 2.0**-49


def unit_floats(points: Sequence[Point]) -> tuple[list[float], list[float], mpq]:
    """Return abscissae and ordinates moved and scaled into [-1, 1], each within 2**-52, and the scale (a power of 2).

    A length in the returned coordinates is the true length divided by the scale.
    """
    if not points:
        return [], [], mpq(1)
    xs, ys = [p.x for p in points], [p.y for p in points]
    left, low = min(xs), min(ys)
    right, top = max(xs), max(ys)
    reach = max(right - left, top - low) / 2
    scale = mpq(1)
    if reach > 0:
        bits = reach.numerator.bit_length() - reach.denominator.bit_length() + 1
        scale = mpq(2) ** bits
    x0, y0 = (left + right) / 2, (low + top) / 2
    return [float((x - x0) / scale) for x in xs], [float((y - y0) / scale) for y in ys], scale


class FilteredPoints:
    """Points with a rounded copy; `orientation(i, j, k)` is that of the exact points."""

    __slots__ = ("_x", "_y", "decided_exactly", "points")

    def __init__(self, points: Sequence[Point]) -> None:
        self.points = points
        self._x, self._y, _ = unit_floats(points)
        self.decided_exactly = 0

    def orientation(self, i: int, j: int, k: int) -> int:
        """Return 1, -1 or 0 as `exactmesh.geometry.predicates.orientation` of the points i, j, k."""
        xs, ys = self._x, self._y
        x, y = xs[i], ys[i]
        a, b, c, d = xs[j] - x, ys[k] - y, ys[j] - y, xs[k] - x
        determinant = a * b - c * d
        bound = _BOUND * (abs(a) + abs(b) + abs(c) + abs(d))
        if determinant > bound:
            return 1
        if determinant < -bound:
            return -1
        self.decided_exactly += 1
        return orientation(self.points[i], self.points[j], self.points[k])
