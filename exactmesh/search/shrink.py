"""Make a figure smaller while a property stays: fewer points, edges and holes, then smaller numbers.

Every step is tried on the property itself, so the result has it. Greedy, deterministic, with a budget of trials: the
result is minimal for the moves below when the budget is not used up.
"""

from collections.abc import Callable, Iterator
from itertools import pairwise

from exactmesh.search.corners import Corner, Corners, normalised
from exactmesh.search.figure import Figure, complexity, divided, images_of, is_planar, normal_form

Property = Callable[[Figure], bool]
# Figures with more points than this lose whole parts first.
_MANY = 8


def shrink(figure: Figure, has: Property, budget: int = 300) -> Figure:
    """Return a figure in normal form with the property `has`, not more complex than `figure`, which has it.

    Figures are normalised before they are tried; if normalising `figure` loses the property, it is returned as it
    came. Among equally small images under the symmetries, the least that has the property is taken.
    """
    best = normal_form(figure)
    if best != figure and not has(best):
        return figure
    tried = {best}
    improved = True
    while improved and budget > 0:
        improved = False
        for candidate in _smaller(best):
            if candidate in tried or complexity(candidate) >= complexity(best) or not is_planar(candidate):
                continue
            tried.add(candidate)
            budget -= 1
            if has(candidate):
                best, improved = candidate, True
                break
            if budget <= 0:
                break
    images = sorted(set(images_of(best)), key=lambda image: (image.points, image.edges, image.holes))
    return next((image for image in images if image == best or has(image)), best)


def _smaller(figure: Figure) -> Iterator[Figure]:
    """Yield simpler figures in normal form, the boldest first."""
    yield divided(figure)
    yield from _fewer_corners(figure.points) if figure.is_polygon else _fewer_parts(figure)
    for places in _smaller_numbers(figure.places):
        yield normal_form(figure.at(places))


def _fewer_corners(corners: Corners) -> Iterator[Figure]:
    """Yield polygons with fewer corners."""
    n = len(corners)
    if n > 3:
        for part in _parts(n):
            yield from (Figure.polygon(normalised(corners[:i] + corners[i + part :]))
                        for i in range(0, n - part + 1, part) if n - part >= 3)


def _fewer_parts(figure: Figure) -> Iterator[Figure]:
    """Yield figures without some points and their edges, without a point in a chain, an edge or a hole point."""
    n = len(figure.points)
    for part in _parts(n):
        for i in range(0, n, part):
            yield normal_form(without(figure, set(range(i, i + part))))
    for v in range(n):
        ends = [u if w == v else w for u, w in figure.edges if v in (u, w)]
        if len(ends) == 2:
            joined = Figure(figure.points, (*figure.edges, (ends[0], ends[1])), figure.holes)
            yield normal_form(without(joined, {v}))
    for i in range(len(figure.edges)):
        yield normal_form(Figure(figure.points, figure.edges[:i] + figure.edges[i + 1 :], figure.holes))
    for i in range(len(figure.holes)):
        yield normal_form(Figure(figure.points, figure.edges, figure.holes[:i] + figure.holes[i + 1 :]))


def without(figure: Figure, dropped: set[int]) -> Figure:
    """Return the figure without some points and all edges that end there."""
    new = {old: i for i, old in enumerate(v for v in range(len(figure.points)) if v not in dropped)}
    return Figure(tuple(figure.points[v] for v in new),
                  tuple((new[u], new[v]) for u, v in figure.edges if u in new and v in new), figure.holes)


def _parts(n: int) -> list[int]:
    """Return how many neighbouring points to leave out at once: halves and less of many, one of few."""
    parts = []
    while n > _MANY:
        n //= 2
        parts.append(n)
    return [*(part for part in parts if part > 1), 1]


def _smaller_numbers(places: Corners) -> Iterator[list[Corner]]:
    for part in (64, 16, 8, 4, 3, 2):
        yield [((2 * x + part) // (2 * part), (2 * y + part) // (2 * part)) for x, y in places]
    for axis in (0, 1):
        yield from _narrowed(places, axis)
    for i, place in enumerate(places):
        for axis in (0, 1):
            for value in _nearer(place[axis], [other[axis] for other in places if other != place]):
                yield [*places[:i], (value, place[1]) if axis == 0 else (place[0], value), *places[i + 1 :]]


def _narrowed(places: Corners, axis: int) -> Iterator[list[Corner]]:
    """Yield places in which a gap between neighbouring coordinates is smaller, everything beyond it following."""
    values = sorted({place[axis] for place in places})
    for low, high in pairwise(values):
        gap = high - low
        for less in sorted({0, 1, gap // 2, gap * 3 // 4, gap - 1}):
            if less < gap:
                shift = gap - less
                yield [(x - shift if axis == 0 and x >= high else x, y - shift if axis == 1 and y >= high else y)
                       for x, y in places]


def _nearer(value: int, others: list[int]) -> list[int]:
    """Return simpler values for one coordinate: 0, a half, the nearest coordinate below, one less."""
    below = [other for other in others if other < value]
    return sorted({0, value // 2, max(below, default=0), value - 1} - {value} if value else set())
