"""Other programs, and what of ours does their work; each is an extra that need not be there."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any, NamedTuple

from exactmesh.api import meshing_of
from exactmesh.claims.run import Run
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.pslg import Pslg

Work = Callable[[], object]


class Case(NamedTuple):
    """A family and a size; `target` bounds our time over theirs there. `short` is for when there is little time."""

    family: str
    n: int
    short: int
    target: float


@dataclass(frozen=True, slots=True)
class Peer:
    """A program with the Python `module` that calls it, and what ours does to be compared.

    `prepared` returns our work and its work on an input, with all data in the form that each of them takes.
    """

    name: str
    module: str
    what: str
    prepared: Callable[[Pslg], tuple[Work, Work]]
    cases: tuple[Case, ...]

    @property
    def is_there(self) -> bool:
        """Whether it can be called."""
        return find_spec(self.module) is not None


def _geos(pslg: Pslg) -> tuple[Work, Work]:
    import shapely

    at = [(float(p.x), float(p.y)) for p in pslg.vertices]
    # In one piece, which takes GEOS less time and memory than loose edges.
    lines = shapely.line_merge(shapely.MultiLineString([[at[u], at[v]] for u, v in pslg.edges]))
    return lambda: minimum_feature_size(pslg), lambda: shapely.minimum_clearance(lines)


def _triangle(pslg: Pslg) -> tuple[Work, Work]:
    import triangle

    given: dict[str, Any] = {"vertices": [(float(p.x), float(p.y)) for p in pslg.vertices],
                             "segments": [list(edge) for edge in pslg.edges]}
    return lambda: meshing_of(Run(pslg)), lambda: triangle.triangulate(given, "pq")


def _sect(pslg: Pslg) -> tuple[Work, Work]:
    from ground.base import get_context
    from sect.triangulation import Triangulation

    context = get_context()
    corners = [context.point_cls(_plain(p.x), _plain(p.y)) for p in pslg.vertices]
    polygon = context.polygon_cls(context.contour_cls(corners), [])

    def theirs() -> object:
        return Triangulation.constrained_delaunay(polygon, context=context).triangles()

    return lambda: meshing_of(Run(pslg)), theirs


def _plain(value: Any) -> Any:
    from fractions import Fraction

    fraction = Fraction(int(value.numerator), int(value.denominator))
    return fraction.numerator if fraction.denominator == 1 else fraction


_MFS, _MESH = "exact mfs with witness", "mesh, all checks, verified"
PEERS: dict[str, Peer] = {
    "geos": Peer("GEOS minimum_clearance", "shapely", _MFS, _geos,
                 (Case("circle", 100_000, 10_000, 10), Case("comb", 100_000, 10_000, 10),
                  Case("star", 100_000, 10_000, 0.1))),
    "triangle": Peer("Triangle pq", "triangle", _MESH, _triangle,
                     (Case("random", 100_000, 10_000, 60), Case("circle", 100_000, 10_000, 60),
                      Case("comb", 100_000, 10_000, 60))),
    "sect": Peer("sect, constrained Delaunay", "sect", _MESH, _sect,
                 (Case("random", 1_000, 200, 0.02), Case("random", 3_000, 400, 0.01))),
}
