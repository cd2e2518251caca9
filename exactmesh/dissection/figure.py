"""The figures to be dissected: polygons with holes, their exact areas and sizes, and the factors that make them fit."""

from collections.abc import Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.distance import distance_squared
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.rational import decimal_text
from exactmesh.planar.faces import Subdivision, domain_of, doubled_walk_area
from exactmesh.planar.pslg import Pslg

MAX_FIGURES = 6
MAX_VERTICES = 2000


@dataclass(frozen=True, slots=True)
class Figure:
    """A polygon with its size before scaling; `corners` is the number of edges along the domain."""

    subdivision: Subdivision
    area: mpq
    corners: int
    mfs_squared: mpq
    diameter_squared: mpq
    scale_squared: mpq
    scale: Real

    @property
    def spread_squared(self) -> mpq:
        """The square of the diameter over the minimum feature size: the paper's r."""
        return self.diameter_squared / self.mfs_squared


def figures_of(pslgs: Sequence[Pslg], scale: bool = False) -> tuple[Figure, ...]:
    """Return the figures; with `scale` the second and later ones are scaled to the area of the first.

    Raises `InputError` when there are fewer than two or too many, when one is no polygon with holes or too large, and
    when the areas differ without `scale`.
    """
    if not 2 <= len(pslgs) <= MAX_FIGURES:
        raise InputError(f"a dissection is of 2 to {MAX_FIGURES} polygons, not {len(pslgs)}")
    subdivisions = [_polygon(pslg, number) for number, pslg in enumerate(pslgs, 1)]
    areas = [domain_area(subdivision) for subdivision in subdivisions]
    for number, area in enumerate(areas, 1):
        if area != areas[0] and not scale:
            raise InputError(f"the areas differ: {_shown(areas[0])} (polygon 1) and {_shown(area)} (polygon {number}); "
                             "--scale makes them equal")
    return tuple(_figure(subdivision, area, areas[0] / area)
                 for subdivision, area in zip(subdivisions, areas, strict=True))


def domain_area(subdivision: Subdivision) -> mpq:
    """Return the exact area of the domain."""
    doubled = sum((doubled_walk_area(subdivision.pslg, subdivision.half_edges, walk)
                   for face in subdivision.domain for walk in face.walks), mpq(0))
    return doubled / 2


def _polygon(pslg: Pslg, number: int) -> Subdivision:
    if len(pslg.vertices) > MAX_VERTICES:
        raise InputError(f"polygon {number} has {len(pslg.vertices)} vertices: a dissection is made of polygons of at "
                         f"most {MAX_VERTICES}")
    subdivision = domain_of(pslg)
    sides = {h for face in subdivision.domain for walk in face.walks for h in walk}
    both = next((h for h in sorted(sides) if h ^ 1 in sides), None)
    if both is not None:
        raise InputError(f"polygon {number}: edge {both >> 1} has the domain on both sides; a dissection is made of "
                         "polygons with holes")
    isolated = next((v for face in subdivision.domain for v in face.isolated), None)
    if isolated is not None:
        raise InputError(f"polygon {number}: vertex {isolated} is isolated; a dissection is made of polygons with "
                         "holes")
    return subdivision


def _figure(subdivision: Subdivision, area: mpq, scale_squared: mpq) -> Figure:
    nearest = minimum_feature_size(subdivision.pslg)
    if nearest is None:
        raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
    origin, points = subdivision.half_edges.origin, subdivision.pslg.vertices
    walked = [h for face in subdivision.domain for walk in face.walks for h in walk]
    ends = sorted({points[origin[h]] for h in walked})
    diameter = max(distance_squared(p, q) for i, p in enumerate(ends) for q in ends[:i])
    return Figure(subdivision, area, len(walked), nearest.squared, diameter, scale_squared, sqrt(scale_squared))


def _shown(area: mpq) -> str:
    text = str(area)
    return text if len(text) <= 60 else f"{text} (about {decimal_text(area)})"
