"""Signed heights of triangles, the measure by which candidates are compared.

The least height of a triangle is its doubled area over its longest side. It is kept as a signed square, so that it
is rational and larger means better: negative when the triangle turns right, zero when it is degenerate.
"""

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area


def height_squared(a: Point, b: Point, c: Point) -> mpq:
    """Return the signed square of the least height of the triangle a, b, c."""
    area = doubled_area(a, b, c)
    if area == 0:
        return mpq(0)
    squared = area * area / max(distance_squared(a, b), distance_squared(b, c), distance_squared(c, a))
    return squared if area > 0 else -squared


def feature_squared(corners: tuple[Point, Point, Point], sides: tuple[list[Point], list[Point], list[Point]]) -> mpq:
    """Return the signed squared feature size of a triangle with T-vertices.

    `sides[i]` lists the T-vertices between corner i and corner i + 1. When the triangle turns right or is degenerate
    its (non-positive) height is returned.
    """
    least = height_squared(*corners)
    if least <= 0:
        return least
    for i in range(3):
        a, b, c = corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]
        for t in sides[i]:
            least = min(least, segment_distance_squared(t, b, c), segment_distance_squared(t, c, a))
    return least
