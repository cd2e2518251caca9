"""Polygons with integer corners: what a search moves, compares and stores.

`Corners` lists the corners in order, without repeating the first. Everything here is exact and quadratic at worst: it
is for polygons of a few dozen corners.
"""

from collections.abc import Iterable, Iterator, Sequence
from math import gcd, lcm

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg, polygon

Corner = tuple[int, int]
Corners = tuple[Corner, ...]


def turn(a: Corner, b: Corner, c: Corner) -> int:
    """Return twice the signed area of the triangle a, b, c."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def doubled_area(corners: Sequence[Corner]) -> int:
    """Return twice the signed area."""
    return sum(corners[i - 1][0] * q[1] - corners[i - 1][1] * q[0] for i, q in enumerate(corners))


def is_between(p: Corner, a: Corner, b: Corner) -> bool:
    """Return whether p, known to be on the line a b, lies on the closed segment."""
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def segments_meet(a: Corner, b: Corner, c: Corner, d: Corner) -> bool:
    """Return whether the closed segments a b and c d have a point in common."""
    s, t, u, v = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if ((s > 0 > t) or (s < 0 < t)) and ((u > 0 > v) or (u < 0 < v)):
        return True
    return ((s == 0 and is_between(c, a, b)) or (t == 0 and is_between(d, a, b))
            or (u == 0 and is_between(a, c, d)) or (v == 0 and is_between(b, c, d)))


def folds_back(a: Corner, b: Corner, c: Corner) -> bool:
    """Return whether the path a b c turns round at b, so that its edges overlap."""
    return turn(a, b, c) == 0 and (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) > 0


def is_simple(corners: Sequence[Corner]) -> bool:
    """Return whether the polygon is simple: edges meet only at common corners; straight angles are allowed."""
    n = len(corners)
    if n < 3 or len(set(corners)) < n:
        return False
    if any(folds_back(corners[i - 2], corners[i - 1], corners[i]) for i in range(n)):
        return False
    if n == 3:
        return turn(*corners) != 0
    return not any(segments_meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])
                   for i in range(n - 2) for j in range(i + 2, n - (i == 0)))


def normalised(corners: Sequence[Corner]) -> Corners:
    """Return the polygon moved into the corner of the first quadrant, counter-clockwise, from its least corner."""
    left, low = min(x for x, _ in corners), min(y for _, y in corners)
    moved = [(x - left, y - low) for x, y in corners]
    if doubled_area(moved) < 0:
        moved.reverse()
    start = moved.index(min(moved))
    return tuple(moved[start:] + moved[:start])


def images(corners: Sequence[Corner]) -> Iterator[Corners]:
    """Yield the eight images under the symmetries of the square, each normalised; some may be equal."""
    for flip_x, flip_y, swap in ((a, b, c) for a in (1, -1) for b in (1, -1) for c in (False, True)):
        moved = [(flip_x * x, flip_y * y) for x, y in corners]
        yield normalised([(y, x) for x, y in moved] if swap else moved)


def canonical(corners: Sequence[Corner]) -> Corners:
    """Return the least image: one for all that differ by translation, symmetry, reversal or start."""
    return min(images(corners))


def divided(corners: Sequence[Corner]) -> Corners:
    """Return the normalised polygon divided by the greatest common divisor of its coordinates."""
    here = normalised(corners)
    common = gcd(*(c for corner in here for c in corner)) or 1
    return tuple((x // common, y // common) for x, y in here)


def pslg_of(corners: Sequence[Corner], name: str = "") -> Pslg:
    """Return the polygon as an input of the product."""
    return polygon(corners, name)


def corners_of(points: Iterable[Sequence[object]]) -> Corners:
    """Return rational points, scaled by their common denominator, as corners."""
    exact = [Point(mpq(x), mpq(y)) for x, y in points]
    scale = lcm(*(int(c.denominator) for point in exact for c in point)) if exact else 1
    return tuple((int(p.x * scale), int(p.y * scale)) for p in exact)
