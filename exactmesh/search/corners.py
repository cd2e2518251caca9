"""Simple polygons with integer corners, brute force.

`Corners` lists the corners in order, without repeating the first. Everything here is exact and quadratic at worst: it
is for polygons of a few dozen corners.
"""

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from exactmesh.families.build import Lattice, doubled_area, turn

Corner: TypeAlias = Lattice
Corners: TypeAlias = tuple[Corner, ...]


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


def images(corners: Sequence[Corner], swaps: bool = True) -> Iterator[Corners]:
    """Yield the eight images under the symmetries of the square, each normalised, or the four that do not swap the
    axes; some may be equal."""
    for flip_x, flip_y, swap in ((a, b, c) for a in (1, -1) for b in (1, -1) for c in (False, True) if swaps or not c):
        moved = [(flip_x * x, flip_y * y) for x, y in corners]
        yield normalised([(y, x) for x, y in moved] if swap else moved)


def canonical(corners: Sequence[Corner], swaps: bool = True) -> Corners:
    """Return the least image: one for all that differ by translation, symmetry, reversal or start."""
    return min(images(corners, swaps))
