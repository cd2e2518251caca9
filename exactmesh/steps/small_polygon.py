"""Triangulate a polygon of a few vertices as well as its vertices allow."""

from collections.abc import Sequence

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.heights import height_squared
from exactmesh.steps.records import Cycle

_Best = tuple[mpq, tuple[Cycle, ...]]


def triangulate_small(points: Sequence[Point]) -> tuple[Cycle, ...]:
    """Return the triangulation without new vertices of a counter-clockwise polygon that has the greatest least height.

    Faces refer to places in `points`; vertices within straight sides are allowed. By dynamic programming over
    sub-polygons: O(k^3) triangles for k points. Diagonals are not tested against the boundary: a triangulation whose
    triangles all turn left and add up to a simple polygon has none that leaves it.
    """
    count = len(points)
    best: dict[tuple[int, int], tuple[mpq | None, int]] = {(i, i + 1): (None, -1) for i in range(count - 1)}
    for width in range(2, count):
        for i in range(count - width):
            j = i + width
            best[i, j] = max(((_least(best[i, k][0], best[k, j][0], height_squared(points[i], points[k], points[j])), k)
                              for k in range(i + 1, j)), key=lambda option: option[0])
    faces: list[Cycle] = []
    pending = [(0, count - 1)]
    while pending:
        i, j = pending.pop()
        k = best[i, j][1]
        if k >= 0:
            faces.append((i, k, j))
            pending += [(i, k), (k, j)]
    return tuple(faces)


def _least(*values: mpq | None) -> mpq:
    return min(value for value in values if value is not None)
