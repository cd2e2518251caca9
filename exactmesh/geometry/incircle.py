"""The in-circle predicate: a float filter with a proven bound in front of the exact polynomial.

With a, b, c, d relative to d and |p|^2 = p.x^2 + p.y^2, the polynomial is

    |a|^2 (b x c) + |b|^2 (c x a) + |c|^2 (a x b),

positive when d lies inside the circle through a, b, c, where these turn left; the sign turns with their order.

The bound. Rounded coordinates (`unit_floats`) lie in [-1, 1] within 2**-52, so the six rounded differences are at most
2 and off by at most eta = 3 * 2**-52. Let A, B, C be the sums of the absolute differences of a, b, c, and
S = A + B + C <= 12. With absolute values throughout, the polynomial is at most Q = A B C (A + B + C), term by term,
and h = 2 eta more in each of A, B, C raises Q by at most

    h * (4/9) * (S + 3 h)**3  =  (8/3) * 2**-52 * (S + 3 h)**3      (dQ/dA + dQ/dB + dQ/dC <= (4/9) S**3).

Seven roundings deep, the evaluation adds 7.1 * 2**-53 * Q <= 1.6 * 2**-52 * S**3, for Q <= S**4 / 27. For S >= 2**-45
the sum is below 5.6 * 2**-52 * S**3 < 2**-49 * S**3; for smaller S the polynomial itself is below 2**-49 * S**3. So a
value beyond 2**-49 * S**3 has the right sign, the rounding of the bound included; anything else is decided exactly.
"""

from collections.abc import Sequence

from gmpy2 import sign

from exactmesh.geometry.filtered import FilteredPoints
from exactmesh.geometry.point import Point

_BOUND = 2.0**-49


def in_circle(a: Point, b: Point, c: Point, d: Point) -> int:
    """Return 1 when d lies inside the circle through a, b, c, -1 outside, 0 on it, for a, b, c that turn left.

    When they turn right, 1 and -1 change places. With two of the four points equal the result is 0; when a, b, c are
    distinct and collinear it is 0 only if d is on their line, and otherwise tells nothing.
    """
    ax, ay, bx, by, cx, cy = a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y, c.x - d.x, c.y - d.y
    return int(sign((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax)
                    + (cx * cx + cy * cy) * (ax * by - ay * bx)))


class CirclePoints(FilteredPoints):
    """`FilteredPoints` with `in_circle(i, j, k, l)`, that of the exact points."""

    __slots__ = ("circles_decided_exactly",)

    def __init__(self, points: Sequence[Point]) -> None:
        super().__init__(points)
        self.circles_decided_exactly = 0

    def in_circle(self, i: int, j: int, k: int, m: int) -> int:
        """Return 1, -1 or 0 as the function `in_circle` of the points i, j, k, m."""
        xs, ys = self._x, self._y
        x, y = xs[m], ys[m]
        ax, ay, bx, by, cx, cy = xs[i] - x, ys[i] - y, xs[j] - x, ys[j] - y, xs[k] - x, ys[k] - y
        value = ((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax)
                 + (cx * cx + cy * cy) * (ax * by - ay * bx))
        size = abs(ax) + abs(ay) + abs(bx) + abs(by) + abs(cx) + abs(cy)
        bound = _BOUND * size * size * size
        if value > bound:
            return 1
        if value < -bound:
            return -1
        self.circles_decided_exactly += 1
        points = self.points
        return in_circle(points[i], points[j], points[k], points[m])
