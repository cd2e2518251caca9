"""What families are put together from: rings, circles of rational points, and pieces of a PSLG."""

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TypeAlias

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Edge, Pslg

Number: TypeAlias = int | Fraction | mpq
Pair: TypeAlias = tuple[Number, Number]
Lattice: TypeAlias = tuple[int, int]

SHARP = Fraction(1, 10**6)


def ring(corners: Iterable[Sequence[Number]], name: str = "") -> Pslg:
    """Return the polygon with these corners in order."""
    vertices = tuple(Point(mpq(x), mpq(y)) for x, y in corners)
    count = len(vertices)
    return Pslg(vertices, tuple((i, (i + 1) % count) for i in range(count)), name=name)


def near_circle(n: int) -> list[Pair]:
    """Return n rational points of the unit circle, near the corners of the regular n-gon."""
    points: list[Pair] = []
    for i in range(n):
        quarter = round(4 * i / n)
        angle = 2 * math.pi * (4 * i - quarter * n) / (4 * n)
        t = Fraction(round(math.tan(angle / 2) * 64 * n), 64 * n)
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        for _ in range(quarter % 4):
            x, y = -y, x
        points.append((x, y))
    return points


def turn(a: Lattice, b: Lattice, c: Lattice) -> int:
    """Return twice the signed area of the triangle a, b, c."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def doubled_area(corners: Sequence[Lattice]) -> int:
    """Return twice the signed area of a polygon."""
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, [*corners[1:], corners[0]], strict=True))


class Builder:
    """Vertices, edges and holes put together piece by piece."""

    def __init__(self) -> None:
        self.vertices: list[Point] = []
        self.edges: list[Edge] = []
        self.holes: list[Point] = []

    def add(self, points: Iterable[Pair], edges: Iterable[Edge], shift: Pair = (0, 0),
            unit: Number = 1) -> None:
        """Add a piece: its points times `unit`, then moved by `shift`; its edges count from its first."""
        first = len(self.vertices)
        self.vertices += [place(p, shift, unit) for p in points]
        self.edges += [(first + u, first + v) for u, v in edges]

    def pslg(self, name: str) -> Pslg:
        return Pslg(tuple(self.vertices), tuple(self.edges), tuple(self.holes), name=name)


def place(p: Pair, shift: Pair, unit: Number) -> Point:
    """Return the point p, scaled by `unit` and then shifted."""
    return Point(mpq(shift[0]) + mpq(p[0]) * mpq(unit), mpq(shift[1]) + mpq(p[1]) * mpq(unit))


def cycle(n: int) -> list[Edge]:
    """Return the edges of a ring through the vertices 0, .., n - 1."""
    return [(i, (i + 1) % n) for i in range(n)]
