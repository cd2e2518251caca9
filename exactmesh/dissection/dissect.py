"""Dissect polygons of equal area into common pieces (paper, Section 5): Lowry's and Montucla's way, overlaid.

In      polygons with holes, as PSLGs; `scale` to make their areas equal; `kind`, the triangulation, None for the best.
Out     `Dissected`: the pieces, their motions, and the counts that the bound is about.
Exact   everything; coordinates of a piece have a square root for each triangle it is part of, and one for a scale.
Raises  `InputError` when the input is refused or too large, `ConstructionFailed` when a bound fails.
Paper   does not say how a triangle becomes a rectangle of height epsilon; here half-turns, slices and one slide.
Check   `verify.py`, which does not import this module.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.dissection.bound import (
    CUTS_ON_A_VERTICAL,
    most_cuts_on_a_vertical,
    rectangle,
    require_bounds,
    spread_bound,
    strip_bound,
)
from exactmesh.dissection.cell import Cell, cells_of, parts
from exactmesh.dissection.figure import Figure, figures_of
from exactmesh.dissection.records import Dissection, Motion, Piece, Vector
from exactmesh.dissection.region import Region
from exactmesh.dissection.triangles import Choice, choose
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.rational import decimal_text
from exactmesh.planar.mesh import Kind
from exactmesh.planar.pslg import Pslg

MAX_CELLS = 3000
_REPORT_EVERY = 100


@dataclass(frozen=True, slots=True)
class Dissected:
    """A dissection and its counts; `spread_bound` is None when the kind of mesh asked for does not carry it."""

    dissection: Dissection
    figures: tuple[Figure, ...]
    kinds: tuple[Kind, ...]
    epsilon: mpq
    cells: tuple[int, ...]
    cuts_on_a_vertical: int
    strip_bound: int
    spread_bound: mpq | None


def dissect(pslgs: Sequence[Pslg], scale: bool = False, kind: Kind | None = None,
            progress: Callable[[str], None] = lambda step: None) -> Dissected:
    """Return a dissection of the polygons with its counts, all bounds asserted."""
    progress("validation")
    figures = figures_of(pslgs, scale)
    choice = choose(figures, kind, progress)
    if sum(choice.cells) > MAX_CELLS:
        raise InputError(f"the strips have {sum(choice.cells)} cells of height {decimal_text(choice.epsilon, 3)}; a "
                         f"dissection is made of at most {MAX_CELLS}: the polygons have too many or too narrow parts")
    progress("strips")
    strips = [_strip(figure, choice, number) for number, figure in enumerate(figures)]
    most = max(most_cuts_on_a_vertical(cell, choice.epsilon) for strip in strips for cell in strip)
    if most > CUTS_ON_A_VERTICAL:
        raise ConstructionFailed("dissection: cuts on a vertical line", most)
    pieces = tuple(_pieces(strips, choice.epsilon, progress))
    require_bounds(figures, choice.cells, len(pieces), choice.carries_bound)
    return Dissected(Dissection(tuple(figure.scale for figure in figures), pieces), figures, choice.kinds,
                     choice.epsilon, choice.cells, most, strip_bound(choice.cells),
                     spread_bound(figures) if choice.carries_bound else None)


def _strip(figure: Figure, choice: Choice, number: int) -> list[Cell]:
    strip: list[Cell] = []
    left = mpq(0)
    for triangle in choice.triangles[number]:
        strip += cells_of(figure, triangle, choice.epsilon, left)
        left = strip[-1].right
    if left * choice.epsilon != figure.area * figure.scale_squared or len(strip) != choice.cells[number]:
        raise ConstructionFailed("dissection: length of the strip", (number, left))
    return strip


def _pieces(strips: list[list[Cell]], epsilon: mpq, progress: Callable[[str], None]) -> Iterator[Piece]:
    """Yield the pieces of the overlay, from left to right."""
    places = sorted({mpq(0)} | {cell.right for strip in strips for cell in strip})
    at = [0] * len(strips)
    for number, (left, right) in enumerate(pairwise(places)):
        if number % _REPORT_EVERY == 0:
            progress(f"overlay, {100 * number // len(places)} %")
        found: list[tuple[Region, tuple[Motion, ...]]] = [(rectangle(left, right, epsilon), ())]
        for a, strip in enumerate(strips):
            while strip[at[a]].right <= left:
                at[a] += 1
            cuts = strip[at[a]].cuts
            found = [(part, (*motions, motion)) for region, motions in found for part, motion in parts(region, cuts)]
        for region, motions in found:
            yield _piece(region, motions)


def _piece(region: Region, motions: tuple[Motion, ...]) -> Piece:
    first = motions[0]
    polygons = tuple(tuple(motion(p) for p in region.corners) for motion in motions)
    return Piece(polygons, tuple(_from(first, motion) for motion in motions[1:]))


def _from(first: Motion, other: Motion) -> Motion:
    """Return the motion that is `other` after the inverse of `first`: both rotate and translate."""
    c: Real = other.a * first.a + other.c * first.c
    s: Real = other.c * first.a - other.a * first.c
    turned = Vector(c * first.x - s * first.y, s * first.x + c * first.y)
    return Motion(c, -s, s, c, other.x - turned.x, other.y - turned.y)
