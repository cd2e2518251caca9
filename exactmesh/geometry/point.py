"""Points with rational coordinates, and the two products every predicate is made of."""

from typing import NamedTuple

from gmpy2 import mpq


class Point(NamedTuple):
    """A place, or a vector: two rationals. Points are ordered by x, then y."""

    x: mpq
    y: mpq

    def __str__(self) -> str:
        return f"({self.x}, {self.y})"


def minus(a: Point, b: Point) -> Point:
    """Return the vector from b to a."""
    return Point(a.x - b.x, a.y - b.y)


def cross(a: Point, b: Point) -> mpq:
    """Return a.x b.y - a.y b.x: positive when b lies counter-clockwise of a."""
    return a.x * b.y - a.y * b.x


def dot(a: Point, b: Point) -> mpq:
    """Return a.x b.x + a.y b.y: positive when a and b make an acute angle."""
    return a.x * b.x + a.y * b.y
