"""Families of figures to search in: a family is a function from a `random.Random` and whole-number parameters.

It returns corners of a polygon, or a `Pslg`. A plug-in is such a function in a file of the user's, named
`path.py:function`; its coordinates may be rational, and what is not planar is drawn again. The same seed gives the same
figures. Parameters that are 0 are drawn anew for each figure.
"""

import inspect
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import accumulate
from typing import TypeVar

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.families import domains, random_polygons, shapes
from exactmesh.families.build import SHARP, ring
from exactmesh.families.changes import big_coordinates, rotated, with_collinear_vertices
from exactmesh.planar.pslg import Pslg
from exactmesh.search.corners import Corner, segments_meet
from exactmesh.search.figure import Figure, is_planar

Family = Callable[[random.Random], Figure]
_Choice = TypeVar("_Choice")
_Drawn = Iterable[Sequence[object]] | Pslg


def points(source: random.Random, n: int, size: int) -> list[Corner]:
    """Return n different lattice points with coordinates up to `size`."""
    if n > (size + 1) ** 2:
        raise InputError(f"there are no {n} lattice points with coordinates up to {size}")
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


def near_contact(source: random.Random, n: int = 0, size: int = 5, scale: int = 1000, gap: int = 3) -> Iterable[Corner]:
    """A magnified tour with one corner moved to within `gap` of the middle of an edge that is not its own."""
    path = [(scale * x, scale * y) for x, y in tour(source, n or source.randint(4, 9), size)]
    v = source.randrange(len(path))
    e = (v + source.randrange(1, len(path) - 1)) % len(path)
    (x, y), (z, w) = path[e], path[(e + 1) % len(path)]
    path[v] = ((x + z) // 2 + source.randint(-gap, gap), (y + w) // 2 + source.randint(-gap, gap))
    return path


def near_circle(source: random.Random, n: int = 0, size: int = 1000) -> Pslg:
    """A regular n-gon (0: 3 to 12) with its corners rounded to a grid: almost cocircular, almost equal edges."""
    corners = shapes.regular_polygon(n or source.randint(3, 12)).vertices
    across = source.randint(size // 10, size)
    return ring([(round(p.x * across), round(p.y * across)) for p in corners])


def midway(source: random.Random, r: int = 0) -> Pslg:
    """The r x 1 rectangle (0: up to 10^4) with two vertices midway on one long side."""
    return shapes.rectangle_with_two_midway_vertices(r or source.randint(2, 10 ** source.randint(1, 4)))


def comb(source: random.Random, teeth: int = 0, floor: int = 0, spacing: int = 0, differ: int = 0) -> Pslg:
    """A room with `teeth` teeth (0: 1 to 8) above a long floor (0: drawn); spacing 1 even, 2 uneven, 3 doubling; tips
    on one level (differ 1), or on levels that differ by a millionth (2)."""
    teeth = teeth or source.randint(1, 8)
    return shapes.comb(teeth, floor or source.randint(2 * teeth + 2, 60 * teeth),
                       _one_of(("even", "uneven", "doubling"), spacing, source), _one_of((0, SHARP), differ, source))


def room(source: random.Random, length: int = 0) -> Pslg:
    """A room with one spike near one end, length up to 1000."""
    return shapes.spike_room(length or source.randint(3, 1000))


def l_shape(source: random.Random, length: int = 0) -> Pslg:
    """An L-shaped hexagon, length up to 1000."""
    return shapes.l_shape(length or source.randint(3, 1000))


def spiral(source: random.Random, turns: int = 0, sort: int = 0) -> Pslg:
    """A corridor wound 1 to 3 times: rectangular (sort 1), curved (2), curved with thin walls (3)."""
    made: tuple[Callable[[int], Pslg], ...] = (
        shapes.rectangular_spiral, partial(shapes.curved_spiral, per_turn=12),
        partial(shapes.walled_spiral, thickness=Fraction(1, 10), per_turn=12))
    return _one_of(made, sort, source)(turns or source.randint(1, 3))


def spike(source: random.Random, sharpness: int = 0) -> Pslg:
    """A square with a spike of angle 1/sharpness (0: up to 10^6)."""
    return shapes.convex_spike(Fraction(1, sharpness or 10 ** source.randint(1, 6)))


def notch(source: random.Random, sharpness: int = 0) -> Pslg:
    """A room with a notch of angle 1/sharpness (0: up to 10^6)."""
    return shapes.reflex_notch(Fraction(1, sharpness or 10 ** source.randint(1, 6)))


def sliver(source: random.Random, length: int = 0, rise: int = 0, bends: int = 0) -> Pslg:
    """A nearly horizontal strip, its ends 1/rise apart in height (0: up to 10^6), with up to 5 bends a side."""
    return shapes.sliver(length or source.randint(2, 1000), Fraction(1, rise or 10 ** source.randint(1, 6)),
                         bends or source.randint(0, 5))


def spikes(source: random.Random, n: int = 0, inner: int = 0) -> Pslg:
    """A star of n spikes (0: 3 to 8), the inner radius 1/inner (0: 2 to 20)."""
    return shapes.star(n or source.randint(3, 8), Fraction(1, inner or source.randint(2, 20)))


def stairs(source: random.Random, steps: int = 0, rise: int = 0) -> Pslg:
    """A staircase of steps (0: 1 to 8) 1/rise high (0: up to 10^3)."""
    return shapes.staircase(steps or source.randint(1, 8), 1, Fraction(1, rise or source.randint(1, 1000)))


def strip(source: random.Random, run: int = 0, pieces: int = 0) -> Pslg:
    """A long strip of height just above 1 that rises by one level of the repaired construction a piece, its two sides
    snapped towards each other."""
    run = run or source.randint(2, 60)
    offset = Fraction(run * source.randint(250, 400), 1000)
    return shapes.leaning_strip(run, offset, pieces=pieces or source.randint(1, 3))


def ledges(source: random.Random, n: int = 0) -> Pslg:
    """A long sharp spike above a floor with ledges (0: 1 to 6)."""
    return random_polygons.spike_with_ledges(n or source.randint(1, 6), _seed(source))


def slits(source: random.Random, count: int = 0, width: int = 1000) -> Pslg:
    """A room with wedges (0: 1 to 5) of width 1/width cut into it from both sides."""
    return random_polygons.slits(count or source.randint(1, 5), _seed(source), Fraction(1, width))


def _of_kind(kind: str) -> Callable[..., Pslg]:
    def drawn(source: random.Random, n: int = 0) -> Pslg:
        return random_polygons.random_simple_polygon(n or source.randint(4, 14), _seed(source), kind)

    return drawn


def holes(source: random.Random, columns: int = 0, rows: int = 0, marked: int = 1) -> Pslg:
    """A rectangle with star-shaped holes, or islands (marked=0), in up to 2 columns and rows."""
    return domains.polygon_with_holes(columns or source.randint(1, 2), rows or source.randint(1, 2), _seed(source),
                                      bool(marked))


def pslg(source: random.Random, cells: int = 0) -> Pslg:
    """Holes, rings, trees, slits, isolated points and maps in cells x cells cells (0: 1 or 2)."""
    return domains.random_pslg(_seed(source), cells or source.randint(1, 2))


def atlas(source: random.Random, columns: int = 0, rows: int = 0) -> Pslg:
    """A map of up to 3 x 3 moved cells with some borders left out."""
    return domains.grid_map(columns or source.randint(1, 3), rows or source.randint(1, 3), _seed(source))


def tree(source: random.Random, columns: int = 0, rows: int = 0) -> Pslg:
    """A tree that hangs freely in a box."""
    return domains.boxed_tree(columns or source.randint(1, 3), rows or source.randint(2, 3), _seed(source))


def segments(source: random.Random, points: int = 0, edges: int = -1, size: int = 0) -> Pslg:
    """Points (0: 1 to 8) in a box, joined by edges (-1: up to as many)."""
    points = points or source.randint(1, 8)
    if size and points > (size - 1) ** 2:
        raise InputError(f"there are no {points} lattice points inside a box of {size}")
    return domains.random_segments(points, source.randint(0, points) if edges < 0 else edges, _seed(source), size)


def rings(source: random.Random, depth: int = 0, marked: int = 0) -> Pslg:
    """Nested squares (0: 2 to 4); when `marked` every second gap is a hole."""
    return domains.nested_rings(depth or source.randint(2, 4), _seed(source), bool(marked))


def wheel(source: random.Random, spokes: int = 0, rim: int = 1) -> Pslg:
    """A vertex of degree 3 to 8, joined to a rim, or with its spokes dangling in a square (rim=0)."""
    return domains.wheel(spokes or source.randint(3, 8), bool(rim))


def walls(source: random.Random, thickness: int = 1000) -> Pslg:
    """A small map drawn apart: every border becomes a wall of 1/thickness."""
    return domains.thin_walls(domains.grid_map(2, source.randint(1, 2), _seed(source)), Fraction(1, thickness))


FAMILIES: dict[str, Callable[..., _Drawn]] = {
    "triangle": triangle, "tour": tour, "orthogonal": orthogonal, "stretched": stretched, "flat": flat,
    "near-degenerate": near_degenerate, "near-contact": near_contact, "near-circle": near_circle,
    "midway": midway, "comb": comb, "room": room, "l-shape": l_shape, "spiral": spiral, "spike": spike, "notch": notch,
    "sliver": sliver, "spikes": spikes, "stairs": stairs, "strip": strip, "ledges": ledges, "slits": slits,
    **{kind: _of_kind(kind) for kind in random_polygons.KINDS},
    "holes": holes, "pslg": pslg, "map": atlas, "tree": tree, "segments": segments, "rings": rings, "wheel": wheel,
    "walls": walls}
# Not simple polygons: the paper's construction is not for these.
DOMAINS = frozenset(("holes", "pslg", "map", "tree", "segments", "rings", "wheel", "walls"))


@dataclass(frozen=True, slots=True)
class _Changes:
    """What may be done to a figure of any family: 1 for yes, and how many vertices to put on each edge."""

    turned: int = 0
    digits: int = 0
    cut: int = 0

    def apply(self, pslg: Pslg, source: random.Random) -> Pslg:
        """Cut every edge, turn by a random angle, exactly, and go to coordinates of 30 digits."""
        if self.cut:
            pslg = with_collinear_vertices(pslg, self.cut)
        if self.turned:
            pslg = rotated(pslg, Fraction(source.randint(1, 99), 100))
        return big_coordinates(pslg, _seed(source)) if self.digits else pslg


_CHANGES = tuple(inspect.signature(_Changes).parameters)


def family_of(name: str, parameters: Mapping[str, int], plugin: str = "") -> Family:
    """Return a family by name, or the function of that name in the text of a plug-in file.

    Every family has the parameters `turned=1` (turned by a random angle, exactly), `cut=K` (K vertices on each edge)
    and `digits=1` (coordinates of 30 digits) too. Raises `InputError` for an unknown name or parameter, and when the
    plug-in cannot be run.
    """
    function = _from_plugin(plugin, name) if plugin else FAMILIES.get(name)
    if function is None:
        raise InputError(f"there is no family {name!r}; there are: lattice, {', '.join(FAMILIES)}, path.py:function")
    known = list(inspect.signature(function).parameters)[1:]
    if unknown := sorted(set(parameters) - set(known) - set(_CHANGES)):
        raise InputError(f"the family {name} has no parameter {unknown[0]!r}; it has: {', '.join((*known, *_CHANGES))}")
    changes = _Changes(**{key: value for key, value in parameters.items() if key in _CHANGES and key not in known})
    own = {key: value for key, value in parameters.items() if key in known}
    return partial(_sample, partial(function, **own), changes)


def _sample(function: Callable[[random.Random], _Drawn], changes: _Changes, source: random.Random) -> Figure:
    try:
        drawn = function(source)
        if not isinstance(drawn, Pslg):
            drawn = ring([(mpq(x), mpq(y)) for x, y in drawn])
        return Figure.of(changes.apply(drawn, source))
    except InputError:
        raise
    except Exception as error:  # a plug-in may fail in any way, a family on parameters that make no sense
        raise InputError(f"the family cannot be drawn: {type(error).__name__}: {error}") from error


def planar_sample(family: Family, source: random.Random, attempts: int = 100) -> Figure | None:
    """Return the first planar figure of a family, None when there is none among many."""
    for _ in range(attempts):
        if is_planar(figure := family(source)):
            return figure
    return None


def _from_plugin(text: str, name: str) -> Callable[..., _Drawn]:
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


def _one_of(choices: Sequence[_Choice], number: int, source: random.Random) -> _Choice:
    """Return the choice with a number from 1, a random one for 0; raises `InputError` for any other."""
    if not 0 <= number <= len(choices):
        raise InputError(f"a choice is a number up to {len(choices)}, not {number}")
    return choices[number - 1] if number else source.choice(choices)


def _seed(source: random.Random) -> int:
    return source.getrandbits(32)
