"""Make a polygon smaller while a property stays: fewer corners, then smaller numbers.

A smaller polygon has fewer corners, or as many with fewer bits, or a smaller sum of coordinates. Every step is tried
on the property itself, so the result has it. Greedy, deterministic, with a budget of trials: the result is minimal for
the moves below when the budget is not used up.
"""

from collections.abc import Callable, Iterator
from itertools import pairwise

from exactmesh.search.corners import Corners, divided, images, is_simple, normalised

Property = Callable[[Corners], bool]


def complexity(corners: Corners) -> tuple[int, int, int, Corners]:
    """Return what shrinking reduces: corners, bits, sum of coordinates, then the list itself."""
    numbers = [c for corner in corners for c in corner]
    return len(corners), sum(c.bit_length() for c in numbers), sum(numbers), corners


def shrink(corners: Corners, has: Property, budget: int = 300) -> Corners:
    """Return a normalised polygon with the property `has`, not more complex than `corners`, which has it.

    Polygons are normalised before they are tried; if normalising or turning `corners` loses the property, the polygon
    is returned as it came. Among equally small images under the symmetries, the least that has the property is taken.
    """
    best = normalised(corners)
    if best != corners and not has(best):
        return corners
    tried = {best}
    improved = True
    while improved and budget > 0:
        improved = False
        for candidate in _smaller(best):
            if candidate in tried or complexity(candidate) >= complexity(best) or not is_simple(candidate):
                continue
            tried.add(candidate)
            budget -= 1
            if has(candidate):
                best, improved = candidate, True
                break
            if budget <= 0:
                break
    return next((image for image in sorted(set(images(best))) if image == best or has(image)), best)


def _smaller(corners: Corners) -> Iterator[Corners]:
    """Yield simpler polygons, the boldest first."""
    n = len(corners)
    yield divided(corners)
    if n > 3:
        for i in range(n):
            yield normalised(corners[:i] + corners[i + 1 :])
    for part in (64, 16, 8, 4, 3, 2):
        yield normalised([((2 * x + part) // (2 * part), (2 * y + part) // (2 * part)) for x, y in corners])
    for axis in (0, 1):
        yield from _narrowed(corners, axis)
    for i, corner in enumerate(corners):
        for axis in (0, 1):
            for value in _nearer(corner[axis], [other[axis] for other in corners if other != corner]):
                moved = (value, corner[1]) if axis == 0 else (corner[0], value)
                yield normalised((*corners[:i], moved, *corners[i + 1 :]))


def _narrowed(corners: Corners, axis: int) -> Iterator[Corners]:
    """Yield polygons in which a gap between neighbouring coordinates is smaller, everything beyond it following."""
    values = sorted({corner[axis] for corner in corners})
    for low, high in pairwise(values):
        gap = high - low
        for less in sorted({0, 1, gap // 2, gap * 3 // 4, gap - 1}):
            if less < gap:
                shift = gap - less
                yield normalised([(x - shift if axis == 0 and x >= high else x,
                                   y - shift if axis == 1 and y >= high else y) for x, y in corners])


def _nearer(value: int, others: list[int]) -> list[int]:
    """Return simpler values for one coordinate: 0, a half, the nearest coordinate below, one less."""
    below = [other for other in others if other < value]
    return sorted({0, value // 2, max(below, default=0), value - 1} - {value} if value else set())
