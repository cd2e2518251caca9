"""Polygons and dissections for these tests."""

from functools import cache
from itertools import pairwise

import families
from gmpy2 import mpq

from exactmesh.dissection.dissect import Dissected, dissect
from exactmesh.dissection.figure import domain_area
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg


def rectangle(width: families.Number, height: families.Number = 1) -> Pslg:
    """Return the rectangle with a corner at the origin."""
    return families.ring([(0, 0), (width, 0), (width, height), (0, height)], f"{width} x {height}")


def triangle(*corners: families.Pair) -> Pslg:
    """Return a triangle."""
    return families.ring(corners, "triangle")


def of_area(pslg: Pslg, area: mpq) -> Pslg:
    """Return the polygon stretched along x to an area."""
    factor = area / domain_area(domain_of(pslg))
    return Pslg(tuple(Point(p.x * factor, p.y) for p in pslg.vertices), pslg.edges,
                tuple(Point(p.x * factor, p.y) for p in pslg.holes), pslg.name)


SQUARE_WITH_HOLE = Pslg(
    tuple(Point(mpq(x), mpq(y)) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 1), (3, 3), (1, 3))),
    ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)), (Point(mpq(2), mpq(2)),), "frame")
TRIANGLE = triangle((0, 0), (4, 0), (1, 2))

KNOWN: dict[str, tuple[Pslg, ...]] = {
    "square to rectangle": (rectangle(2, 2), rectangle(4)),
    "square to itself": (rectangle(1), rectangle(1)),
    "triangle to triangle": (TRIANGLE, triangle((0, 0), (2, 0), (5, 4))),
    "triangle to square": (TRIANGLE, rectangle(2, 2)),
    "right triangle to rectangle": (triangle((0, 0), (4, 0), (0, 3)), rectangle(3, 2)),
    "far from the origin": (families.translated(rectangle(2, 2), 10**6, -(10**6)), rectangle(4)),
    "clockwise": (families.reversed_orientation(rectangle(2, 2)), TRIANGLE),
    "hexagon to square": (families.regular_polygon(6), of_area(rectangle(1), mpq(1))),
    "hole": (SQUARE_WITH_HOLE, rectangle(4, 3)),
    "L to comb": (families.l_shape(4), of_area(families.comb(2), mpq(6))),
    "three": (rectangle(2, 2), rectangle(4), TRIANGLE),
    "four": (rectangle(2, 2), rectangle(4), TRIANGLE, triangle((0, 0), (2, 0), (5, 4))),
}
NEEDS_SCALE = {"hexagon to square", "L to comb"}


@cache
def dissected(name: str) -> Dissected:
    """Return the dissection of a known case, made once."""
    return dissect(KNOWN[name], scale=name in NEEDS_SCALE)


def shoelace(points: list[tuple[float, float]]) -> float:
    """Return a signed area."""
    return sum(x * v - y * u for (x, y), (u, v) in pairwise([*points, points[0]])) / 2
