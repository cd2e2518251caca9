"""Predicates: each is the sign of one polynomial, evaluated exactly.

`doubled_area(a, b, c)` is (b - a) x (c - a): positive when a, b, c turn left, zero when they are collinear.
"""

from gmpy2 import mpq

from exactmesh.geometry.point import Point


def doubled_area(a: Point, b: Point, c: Point) -> mpq:
    """Return twice the signed area of the triangle a, b, c; positive when it turns left."""
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def orientation(a: Point, b: Point, c: Point) -> int:
    """Return 1 when a, b, c turn left, -1 when they turn right, 0 when collinear or not all distinct."""
    # Integers over common denominators, which are positive: rationals would take a gcd for every operation.
    (ax, ay), (bx, by), (cx, cy) = a, b, c
    x, x_den, y, y_den = ax.numerator, ax.denominator, ay.numerator, ay.denominator
    bx_den, by_den, cx_den, cy_den = bx.denominator, by.denominator, cx.denominator, cy.denominator
    left = (bx.numerator * x_den - x * bx_den) * (cy.numerator * y_den - y * cy_den) * (by_den * cx_den)
    right = (by.numerator * y_den - y * by_den) * (cx.numerator * x_den - x * cx_den) * (bx_den * cy_den)
    return int(left > right) - int(left < right)


def is_ahead(a: Point, b: Point, c: Point) -> bool:
    """Return whether the walk a, b, c goes on forwards at b: (b - a) . (c - b) > 0."""
    return bool((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) > 0)


def is_between(a: Point, p: Point, b: Point) -> bool:
    """Return whether p, known to be collinear with a and b, lies in the closed segment a b."""
    return min(a, b) <= p <= max(a, b)


def line_crossing(a: Point, b: Point, c: Point, d: Point) -> Point:
    """Return the point where the lines a b and c d meet.

    Raises `ZeroDivisionError` when they are parallel.
    """
    rx, ry, sx, sy = b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y
    t = ((c.x - a.x) * sy - (c.y - a.y) * sx) / (rx * sy - ry * sx)
    return Point(a.x + t * rx, a.y + t * ry)


def x_at(a: Point, b: Point, y: mpq) -> mpq:
    """Return the abscissa of the line a b, which is not horizontal, at height y."""
    return a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)
