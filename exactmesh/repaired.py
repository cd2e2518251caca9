"""The repaired construction: a triangulation of every face of the domain.

A nonproper one has degradation below 21.6; a proper one pays a logarithm.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.collector import collector_paused
from exactmesh.errors import InputError
from exactmesh.geometry.columns import Columns
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.steps.balance import REPAIRED, Balance
from exactmesh.steps.columns import triangulate_in_columns
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.offset import offset
from exactmesh.steps.records import Offset, Patch, Shape, Trapezoidation
from exactmesh.steps.shape import shape_of
from exactmesh.steps.trapezoidation import trapezoidate
from exactmesh.steps.tube import triangulate_tube, triangulate_tube_in_columns


@dataclass(frozen=True, slots=True)
class Construction:
    """The result of every step, in units of `shape.unit`, and the finished mesh."""

    shape: Shape
    offset: Offset
    trapezoidation: Trapezoidation
    interior: Patch
    tube: Patch
    mesh: Mesh

    @property
    def points(self) -> tuple[Point, ...]:
        """All vertices, in units of `shape.unit`."""
        return (self.shape.points + self.offset.points + self.trapezoidation.points + self.interior.points
                + self.tube.points)


@collector_paused()
def construct(subdivision: Subdivision, size_squared: mpq, progress: Callable[[str], None] = lambda step: None,
              kind: Kind = "nonproper", balance: Balance = REPAIRED) -> Construction:
    """Return the mesh of the domain of `subdivision`, step by step; `progress` is told the name of each step.

    `size_squared` is the squared feature size to be kept: the mfs, or the ifs for an internal mesh. A proper mesh has
    layers where a nonproper one has T-vertices; an internal one passes T-vertices on, up to the edges of P. A balance
    other than the usual one is for nonproper meshes.

    Raises `ConstructionFailed` when a step finds no triangulation, which would be a counterexample to the design.
    """
    if kind == "internal":
        _refuse_shared_edges(subdivision)
    shape = shape_of(subdivision, size_squared)
    progress("offset")
    q = offset(shape, balance)
    progress("trapezoidation")
    chords = trapezoidate(q)
    points = Columns([*shape.points, *q.points, *chords.points])
    progress("interior")
    interior = (triangulate_in_columns(q, chords, points) if kind == "internal" else
                triangulate_interior(q, chords, points, kind == "proper", balance))
    points = points.extended(interior.points)
    progress("tube")
    chord_ends = [(edge, chords.first + i) for i, edge in enumerate(chords.edge)]
    recorded = chord_ends + list(interior.on_edge)
    tube = (triangulate_tube_in_columns(shape, q, recorded, points) if kind == "internal" else
            triangulate_tube(shape, q, recorded, points, kind == "proper", balance))
    mesh = Mesh(kind, subdivision.pslg.vertices + _scaled(q.points + chords.points, interior.points + tube.points,
                                                          shape.unit), shape.triangles + interior.faces + tube.faces)
    return Construction(shape, q, chords, interior, tube, mesh)


def _scaled(on_levels: Sequence[Point], others: Sequence[Point], unit: mpq) -> tuple[Point, ...]:
    """Return points in the units of the input; those on one level, which share an ordinate, still share it."""
    ordinates = {p.y: p.y * unit for p in {id(p.y): p for p in on_levels}.values()}
    return (*(Point(p.x * unit, ordinates[p.y]) for p in on_levels),
            *(Point(p.x * unit, p.y * unit) for p in others))


def _refuse_shared_edges(subdivision: Subdivision) -> None:
    """Raise `InputError` for an edge with the domain on both sides: vertices put on it from both would differ."""
    inside = {h for face in subdivision.domain for walk in face.walks for h in walk}
    for edge, ends in enumerate(subdivision.pslg.edges):
        if {2 * edge, 2 * edge + 1} <= inside:
            raise InputError(f"edge {edge} {ends} has the domain on both sides: internal meshes, which put vertices on "
                             "edges, are made only where every edge has it on one side")
