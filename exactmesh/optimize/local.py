"""The neighbourhood of a vertex in floats around it, and exact points of few bits from there."""

from collections.abc import Sequence
from math import floor, frexp, inf, isfinite

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.optimize.faces import Faces
from exactmesh.optimize.place import Spot, middle_of

# Steiner vertices lie on grids of multiples of 2^-k, about in units of the input's mfs, k at most this.
_FINEST = 40


class Local:
    """Rounded coordinates relative to a vertex: differences are exact before they are rounded."""

    def __init__(self, faces: Faces, origin: int) -> None:
        self._point = faces.point
        self._origin = faces.point[origin]
        self._known: dict[int, Spot] = {}

    def __getitem__(self, v: int) -> Spot:
        spot = self._known.get(v)
        if spot is None:
            spot = self._known[v] = self.spot(self._point[v])
        return spot

    def spot(self, point: Point) -> Spot:
        """Return the rounded coordinates of a point."""
        x, y = point.x - self._origin.x, point.y - self._origin.y
        try:
            return float(x), float(y)
        except OverflowError:
            return inf, inf

    def simple_point(self, region: Sequence[Spot]) -> Point | None:
        """Return a point of about the fewest bits in a convex polygon: on the coarsest grid that has one near its
        middle. None when the polygon is too thin for the finest grid."""
        x, y = middle_of(region)
        if not (isfinite(x) and isfinite(y)):
            return None
        ox, oy = self._origin
        at = Point(ox + mpq(x), oy + mpq(y))
        # No coarser grid has a point in it, but by luck far from the middle.
        width = max(max(abs(a - x), abs(b - y)) for a, b in region)
        for bits in range(max(0, -frexp(width)[1]), _FINEST + 1):
            unit = mpq(1, 1 << bits)
            column, row = floor(at.x / unit), floor(at.y / unit)
            best: tuple[float, Point] | None = None
            for i in (column, column + 1):
                for j in (row, row + 1):
                    point = Point(i * unit, j * unit)
                    spot = self.spot(point)
                    if _is_inside(region, spot):
                        off = (spot[0] - x) ** 2 + (spot[1] - y) ** 2
                        if best is None or off < best[0]:
                            best = off, point
            if best is not None:
                return best[1]
        return None


def _is_inside(region: Sequence[Spot], spot: Spot) -> bool:
    x, y = spot
    a, b = region[-1]
    for c, d in region:
        if (c - a) * (y - b) - (d - b) * (x - a) < 0:
            return False
        a, b = c, d
    return True
