"""The number of pieces: the bounds proved in docs/dissection.md, asserted on every run.

With N_a cells in the strip of figure a, N their sum, k figures:

    cuts on a vertical line, of one strip                <= 3
    pieces  <=  9 N + sum over pairs a < b of (55 (N_a + N_b) - 49)  <=  55 k N
    N       <=  125 (sum of n) (greatest r)             for nonproper meshes, and the choice has no more
    pieces  <=  6875 k (sum of n) (sum of r)
"""

from collections.abc import Sequence
from itertools import combinations

from gmpy2 import mpq

from exactmesh.dissection.cell import MAX_PARTS, Cell, parts
from exactmesh.dissection.figure import Figure
from exactmesh.dissection.records import Vector
from exactmesh.dissection.region import Line, Region
from exactmesh.errors import ConstructionFailed
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.rational import sqrt_below

CUTS_ON_A_VERTICAL = 3
# 7 x 7 crossings of slanted cuts in a pair of cells, of which there are N_a + N_b - 1.
SLANTED = 49
# A cell has two upright cuts, its left border among them.
CROSSINGS = SLANTED + 2 * CUTS_ON_A_VERTICAL
CELLS_PER_CORNER_AND_SPREAD = 125
PIECES = CROSSINGS * CELLS_PER_CORNER_AND_SPREAD
_ROOT_BITS = 64


def rectangle(left: mpq, right: mpq, height: mpq) -> Region:
    """Return the part of the strip between two abscissae."""
    zero, one = Real(0), Real(1)
    x0, x1, y1 = Real(left), Real(right), Real(height)
    corners = Vector(x0, zero), Vector(x1, zero), Vector(x1, y1), Vector(x0, y1)
    return Region(corners, (Line(zero, one, zero), Line(one, zero, -x1), Line(zero, one, -y1), Line(one, zero, -x0)))


def most_cuts_on_a_vertical(cell: Cell, epsilon: mpq) -> int:
    """Return how many cuts of a cell a vertical line meets at most, among those that hold no corner of a part.

    Raises `ConstructionFailed` when the cell has more than 9 parts.
    """
    found = parts(rectangle(cell.left, cell.right, epsilon), cell.cuts)
    if len(found) > MAX_PARTS:
        raise ConstructionFailed("dissection: parts of a cell", len(found))
    spans = [(min(p.x for p in region.corners), max(p.x for p in region.corners)) for region, _ in found]
    # The most spans over one place lie over the start of one of them.
    return max(sum(low <= start < high for low, high in spans) for start, _ in spans) - 1


def strip_bound(cells: Sequence[int]) -> int:
    """Return the bound on the pieces by the numbers of cells."""
    return MAX_PARTS * sum(cells) + sum(CROSSINGS * (a + b) - SLANTED for a, b in combinations(cells, 2))


def spread_bound(figures: Sequence[Figure]) -> mpq:
    """Return a rational at most 6875 k (sum of n) (sum of r): each root is rounded down, at the 64th bit."""
    spreads = sum((sqrt_below(figure.spread_squared, _ROOT_BITS) for figure in figures), mpq(0))
    return PIECES * len(figures) * sum(figure.corners for figure in figures) * spreads


def require_bounds(figures: Sequence[Figure], cells: Sequence[int], pieces: int, carries_bound: bool) -> None:
    """Raise `ConstructionFailed` when there are more pieces than a bound allows."""
    if pieces > strip_bound(cells):
        raise ConstructionFailed("dissection: pieces by cells", (pieces, tuple(cells)))
    if carries_bound and pieces > spread_bound(figures):
        raise ConstructionFailed("dissection: pieces by spread", (pieces, spread_bound(figures)))
