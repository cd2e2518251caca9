"""Squared distances, exactly. A length is never taken: comparisons compare squares."""

from gmpy2 import mpq

from exactmesh.geometry.point import Point


def distance_squared(a: Point, b: Point) -> mpq:
    """Return |a b|^2."""
    x, y = b.x - a.x, b.y - a.y
    return x * x + y * y


def line_distance_squared(p: Point, a: Point, b: Point) -> mpq:
    """Return the squared distance of p from the line a b, a != b."""
    x, y = b.x - a.x, b.y - a.y
    area = x * (p.y - a.y) - y * (p.x - a.x)
    return area * area / (x * x + y * y)


def segment_distance_squared(p: Point, a: Point, b: Point) -> mpq:
    """Return the squared distance of p from the closed segment a b; a = b is allowed."""
    x, y = b.x - a.x, b.y - a.y
    px, py = p.x - a.x, p.y - a.y
    along = x * px + y * py
    if along <= 0:
        return px * px + py * py
    length_squared = x * x + y * y
    if along >= length_squared:
        return distance_squared(p, b)
    area = x * py - y * px
    return area * area / length_squared
