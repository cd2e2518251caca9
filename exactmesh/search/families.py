"""Random polygons: a family is a function from a `random.Random` and whole-number parameters to corners.

A plug-in is such a function in a file of the user's, named `path.py:function`; it may return rational coordinates and
polygons that are not simple, which are skipped. The same seed gives the same polygons.
"""

import inspect
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from itertools import accumulate
from math import atan2

from exactmesh.errors import InputError
from exactmesh.search.corners import Corner, Corners, corners_of, is_simple, segments_meet

Family = Callable[[random.Random], Corners]


def points(source: random.Random, n: int, size: int) -> list[Corner]:
    """Return n different lattice points with coordinates up to `size`."""
    chosen: dict[Corner, None] = {}
    while len(chosen) < n:
        chosen[source.randint(0, size), source.randint(0, size)] = None
    return list(chosen)


def triangle(source: random.Random, size: int = 40) -> Iterable[Corner]:
    """A triangle on lattice points up to `size`."""
    return points(source, 3, size)


def tour(source: random.Random, n: int = 0, size: int = 30) -> Iterable[Corner]:
    """A random tour of n points (0: 3 to 10) made simple by uncrossing."""
    path = points(source, n or source.randint(3, 10), size)
    for _ in range(8 * len(path)):
        if not _uncross(path):
            break
    return path


def star(source: random.Random, n: int = 0, size: int = 60) -> Iterable[Corner]:
    """n points (0: 4 to 12) sorted by direction from the middle."""
    chosen = points(source, n or source.randint(4, 12), size)
    return sorted(chosen, key=lambda p: atan2(2 * p[1] - size, 2 * p[0] - size))


def orthogonal(source: random.Random, n: int = 0, size: int = 6) -> Iterable[Corner]:
    """A staircase-sided histogram of n columns (0: 2 to 5), so with right angles only and equal levels."""
    heights = [source.randint(1, size)]
    for _ in range((n or source.randint(2, 5)) - 1):
        heights.append(source.choice([h for h in range(1, size + 1) if h != heights[-1]]))
    xs = [0, *accumulate(source.randint(1, size) for _ in heights)]
    top = [corner for x, y, h in zip(xs, xs[1:], heights, strict=False) for corner in ((x, h), (y, h))]
    return [(xs[-1], 0), *reversed(top), (0, 0)][::-1]


def stretched(source: random.Random, n: int = 0, size: int = 6, most: int = 200) -> Iterable[Corner]:
    """A small tour or histogram whose grid columns and rows get widths from 1 to `most`: a large spread."""
    cornered = source.random() < 0.5
    small = list(orthogonal(source, 0, size) if cornered else tour(source, n or source.randint(4, 8), size))
    wide, high = (source.random() < 0.7 for _ in range(2))
    width, height = max(x for x, _ in small), max(y for _, y in small)
    xs = [0, *accumulate(_width(source, most, wide) for _ in range(width))]
    ys = [0, *accumulate(_width(source, most, high) for _ in range(height))]
    return [(xs[x], ys[y]) for x, y in small]


def near_degenerate(source: random.Random, n: int = 0, size: int = 5, scale: int = 1000, shift: int = 3
                    ) -> Iterable[Corner]:
    """A stretched polygon, magnified, with corners moved by a little: almost equal levels, almost straight angles."""
    moved = [(scale * x, scale * y) for x, y in stretched(source, n, size, 40)]
    return [(x + source.randint(-shift, shift), y + source.randint(-shift, shift)) for x, y in moved]


def flat(source: random.Random, size: int = 200, rise: int = 6) -> Iterable[Corner]:
    """A triangle or quadrilateral with nearly horizontal sides."""
    slant = source.randint(-rise, rise)
    a, b, c, d = (source.randint(1, size) for _ in range(4))
    low = [(0, 0), (a, slant)]
    high = [(a + source.randint(-b, b), slant + c), (source.randint(-b, b), c + source.randint(-rise, rise))]
    return [*low, *(high if d % 2 else high[:1])]


FAMILIES: dict[str, Callable[..., Iterable[Corner]]] = {
    "triangle": triangle, "tour": tour, "star": star, "orthogonal": orthogonal, "stretched": stretched,
    "near-degenerate": near_degenerate, "flat": flat}


def family_of(name: str, parameters: Mapping[str, int], plugin: str = "") -> Family:
    """Return a family by name, or the function of that name in the text of a plug-in file.

    Raises `InputError` for an unknown name or parameter, and when the plug-in cannot be run.
    """
    function = _from_plugin(plugin, name) if plugin else FAMILIES.get(name)
    if function is None:
        raise InputError(f"there is no family {name!r}; there are: lattice, {', '.join(FAMILIES)}, path.py:function")
    known = list(inspect.signature(function).parameters)[1:]
    if unknown := sorted(set(parameters) - set(known)):
        raise InputError(f"the family {name} has no parameter {unknown[0]!r}; it has: {', '.join(known) or 'none'}")
    return partial(_sample, partial(function, **parameters))


def _sample(function: Callable[[random.Random], Iterable[Sequence[object]]], source: random.Random) -> Corners:
    return corners_of(function(source))


def simple_sample(family: Family, source: random.Random, attempts: int = 100) -> Corners | None:
    """Return the first simple polygon of a family, None when there is none among many."""
    for _ in range(attempts):
        if is_simple(corners := family(source)):
            return corners
    return None


def _from_plugin(text: str, name: str) -> Callable[..., Iterable[Corner]]:
    space: dict[str, object] = {"__name__": "exactmesh_family"}
    try:
        exec(compile(text, "family plug-in", "exec"), space)
    except Exception as error:
        raise InputError(f"the plug-in cannot be run: {type(error).__name__}: {error}") from error
    function = space.get(name)
    if not callable(function):
        raise InputError(f"the plug-in has no function {name!r}")
    return function


def _width(source: random.Random, most: int, wide: bool) -> int:
    return source.choice((1, 1, 2, 3, source.randint(1, most))) if wide else 1


def _uncross(path: list[Corner]) -> bool:
    """Reverse a part of the tour at the first pair of edges that meet; return whether there was one."""
    n = len(path)
    for i in range(n - 1):
        for j in range(i + 2, n - (i == 0)):
            if segments_meet(path[i], path[i + 1], path[j], path[(j + 1) % n]):
                path[i + 1 : j + 1] = path[i + 1 : j + 1][::-1]
                return True
    return False
