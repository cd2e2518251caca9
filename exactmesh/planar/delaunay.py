"""The constrained Delaunay triangulation of the domain, exactly, by Lawson's flips.

A side that is no input edge is flipped while one of the two vertices opposite to it lies strictly inside the circle
through the triangle on its other side. Each flip lowers the surface lifted to z = x^2 + y^2, so the flips end; then no
circle through a triangle has a vertex inside that the triangle sees (Lee and Lin 1986). Where four vertices lie on one
circle, the diagonal stays as it was met, and the result is unique but for these.

The number of flips is quadratic at worst, few where the sweep that finds the first triangulation runs along the
domain and not along rows of vertices. So it runs along the main axis of the vertices; when that takes many flips,
across it, and then in a direction between.
"""

from collections.abc import Callable, MutableMapping, Sequence
from collections.abc import Set as AbstractSet
from math import atan2, cos, sin

import numpy as np

from exactmesh.geometry.filtered import unit_floats
from exactmesh.geometry.incircle import CirclePoints
from exactmesh.geometry.point import Point
from exactmesh.planar.cycles import Side
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.triangulation import Triangulation, triangles_from, triangulate

# Flips for each side after which another first triangulation is tried.
_MANY = 2


def constrained_delaunay(subdivision: Subdivision) -> Triangulation:
    """Return the constrained Delaunay triangulation of the domain."""
    points = subdivision.pslg.vertices
    x, y = main_axis(points)
    for along in ((x, y), (-y, x), (5 * x - 2 * y, 2 * x + 5 * y)):
        start = triangulate(subdivision, along)
        result = flipped(points, start, _MANY * len(start.apex))
        if result is not None:
            return result
    return delaunay_from(points, start)


def delaunay_from(points: Sequence[Point], start: Triangulation) -> Triangulation:
    """Return `start` after all flips; its constrained sides stay."""
    result = flipped(points, start)
    if result is None:
        raise AssertionError("without a limit the flips end")
    return result


def flipped(points: Sequence[Point], start: Triangulation, limit: int | None = None) -> Triangulation | None:
    """Return `start` after all flips; its constrained sides stay. None when there are more than `limit` of them."""
    apex = dict(start.apex)
    pending = [side for side in apex if side[0] < side[1] and side not in start.constrained]
    if flip(apex, start.constrained, CirclePoints(points).in_circle, pending, limit) is None:
        return None
    return Triangulation(triangles_from(apex), start.constrained, apex)


def flip(apex: MutableMapping[Side, int], constrained: AbstractSet[Side],
         in_circle: Callable[[int, int, int, int], int], pending: list[Side], limit: int | None = None
         ) -> list[Side] | None:
    """Flip the `pending` sides that are not locally Delaunay, and those around them, until none is left.

    `apex` is changed and `pending` used up. Return the constrained sides that have got another triangle; None when
    `limit` flips do not suffice, with the triangulation as it is by then.
    """
    met: list[Side] = []
    flips = 0
    while pending:
        side = pending.pop()
        # A side may have been flipped away since it was put here.
        if side not in apex:
            continue
        u, v = side
        w, x = apex[side], apex[v, u]
        if in_circle(u, v, w, x) <= 0:
            continue
        if flips == limit:
            return None
        flips += 1
        # The triangles u v w and v u x become u x w and x v w.
        del apex[side], apex[v, u]
        apex[u, x] = apex[x, v] = w
        apex[v, w] = apex[w, u] = x
        apex[x, w], apex[w, x] = u, v
        for outer in ((v, w), (w, u), (u, x), (x, v)):
            (met if outer in constrained else pending).append(outer)
    return met


def main_axis(points: Sequence[Point]) -> tuple[int, int]:
    """Return about the direction in which the points spread most, as a vector of small integers."""
    x, y, _ = unit_floats(points)
    if len(x) < 2:
        return 1, 0
    (xx, xy), (_, yy) = np.cov(x, y).tolist()
    angle = atan2(2 * xy, xx - yy) / 2
    return round(64 * cos(angle)), round(64 * sin(angle))
