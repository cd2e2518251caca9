"""Triangles to dissect: triangulations of the figures, of the kinds that give the fewest strips.

Every triangulation will do for a dissection; the bound on the number of pieces is carried by the nonproper one of the
repaired construction, which is always among the candidates when no kind is asked for.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import product

from gmpy2 import isqrt, mpq

from exactmesh.claims.run import Run
from exactmesh.dissection.figure import Figure
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.measure.face_feature import NotTriangle, corners_of
from exactmesh.numbers.rational import sqrt_below
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.steps.constants import DESIGN_DEGRADATION, VERTICES_PER_CORNER

KINDS: tuple[Kind, ...] = ("classic", "internal", "nonproper")
# Two triangles at a Steiner vertex, and fewer than two at a corner (docs/dissection.md).
TRIANGLES_PER_CORNER = 2 * VERTICES_PER_CORNER + 2
# epsilon is rounded down to so many significant bits: it loses less than one part in 2**(EPSILON_BITS - 1).
EPSILON_BITS = 8
# The best classic mesh is sought up to so many corners; its search takes cubic time.
_OPTIMAL_CORNERS = 40


@dataclass(frozen=True, slots=True)
class Triangle:
    """A counter-clockwise triangle, start, end and apex, on its longest side, before scaling."""

    start: Point
    end: Point
    apex: Point
    base_squared: mpq
    area: mpq

    @property
    def half_height_squared(self) -> mpq:
        """The square of half the height over the base: that of the height of the rectangle."""
        return self.area**2 / self.base_squared


@dataclass(frozen=True, slots=True)
class Choice:
    """Triangles of each figure, the kinds they are from, the height of the strip and the number of cells in each."""

    kinds: tuple[Kind, ...]
    triangles: tuple[tuple[Triangle, ...], ...]
    epsilon: mpq
    cells: tuple[int, ...]
    carries_bound: bool


def choose(figures: Sequence[Figure], kind: Kind | None, progress: Callable[[str], None]) -> Choice:
    """Return the triangulations with the fewest cells in all; of kind `kind` when it is given.

    Raises `InputError` when a figure has no mesh of that kind, and `ConstructionFailed` when a nonproper one does not
    keep what it promises.
    """
    found = [_candidates(figure, number, kind, progress) for number, figure in enumerate(figures, 1)]
    # All combinations for a few figures, else one kind for all: the nonproper one is among both.
    combinations: Iterable[tuple[Kind, ...]] = (
        product(*found) if len(figures) <= 3 else
        [(name,) * len(figures) for name in KINDS if all(name in each for each in found)])
    best: Choice | None = None
    for kinds in combinations:
        triangles = tuple(each[name] for each, name in zip(found, kinds, strict=True))
        heights = [[figure.scale_squared * t.half_height_squared for t in each]
                   for figure, each in zip(figures, triangles, strict=True)]
        epsilon = sqrt_below(min(map(min, heights)), EPSILON_BITS)
        cells = tuple(sum(int(isqrt(h // epsilon**2)) for h in each) for each in heights)
        if best is None or sum(cells) < sum(best.cells):
            best = Choice(kinds, triangles, epsilon, cells, kind in (None, "nonproper"))
    if best is None:
        raise AssertionError("the nonproper meshes are always among the combinations")
    return best


def _candidates(figure: Figure, number: int, kind: Kind | None, progress: Callable[[str], None]
                ) -> dict[Kind, tuple[Triangle, ...]]:
    found: dict[Kind, tuple[Triangle, ...]] = {}
    for name in KINDS if kind is None else (kind,):
        progress(f"triangulation of polygon {number}, {name}")
        try:
            mesh = _mesh(figure, name)
        except InputError as error:
            if kind is not None:
                raise InputError(f"polygon {number}: {error}") from error
            continue
        found[name] = tuple(_triangle(mesh, cycle) for cycle in mesh.faces)
        if name == "nonproper":
            _check_promise(figure, found[name])
    return found


def _mesh(figure: Figure, kind: Kind) -> Mesh:
    pslg = figure.subdivision.pslg
    if kind != "classic":
        return Run(pslg, "repaired", kind).mesh
    domain = figure.subdivision.domain
    simple = len(domain) == 1 and not domain[0].inner and figure.corners <= _OPTIMAL_CORNERS
    try:
        return Run(pslg, "classic", "classic", optimal=simple).mesh
    except InputError:
        return Run(pslg, "classic", "classic").mesh


def _triangle(mesh: Mesh, cycle: tuple[int, ...]) -> Triangle:
    corners = corners_of(mesh.vertices, cycle)
    if isinstance(corners, NotTriangle):
        raise ConstructionFailed("triangulation", corners)
    a, b, c = (mesh.vertices[cycle[i]] for i in corners)
    turned = ((a, b, c), (b, c, a), (c, a, b))
    start, end, apex = max(turned, key=lambda t: distance_squared(t[0], t[1]))
    return Triangle(start, end, apex, distance_squared(start, end), doubled_area(start, end, apex) / 2)


def _check_promise(figure: Figure, triangles: Sequence[Triangle]) -> None:
    """Raise `ConstructionFailed` when there are too many triangles, or one is too low, for the bound on the pieces."""
    if len(triangles) > TRIANGLES_PER_CORNER * figure.corners:
        raise ConstructionFailed("dissection: number of triangles", (len(triangles), figure.corners))
    least = min(4 * t.half_height_squared for t in triangles)
    if least * DESIGN_DEGRADATION**2 < figure.mfs_squared:
        raise ConstructionFailed("dissection: least height", (least, figure.mfs_squared))
