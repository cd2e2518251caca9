"""The paper's construction to the letter, gaps included: what its text leaves open is a named option."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import get_args

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.steps.lemma_3 import Teeth
from exactmesh.steps.offset_curve import RightAngle, offset_curve
from exactmesh.steps.paper_interior import triangulate_with_centres
from exactmesh.steps.paper_tube import Filling, Tall, TubeOptions, triangulate_tube_in_phases
from exactmesh.steps.reading import READINGS, ReadingName
from exactmesh.steps.records import Offset, OffsetCurve, PaperTube, Patch, Shape, Trapezoidation
from exactmesh.steps.snap import Ties, grid_spacing, snap
from exactmesh.steps.trapezoidation import trapezoidate


@dataclass(frozen=True, slots=True)
class PaperOptions:
    """The choices that the text leaves open; the defaults are the most literal ones.

    `rectangle` is no such choice: Theorem 1 fills the Tube's rectangles with Lemma 3, Theorem 2 in layers.
    """

    reading: ReadingName = "octagon"
    right_angle: RightAngle = "chords"
    ties: Ties = "up"
    teeth: Teeth = "midpoint"
    tall: Tall = "lemma-1"
    rectangle: Filling = "nested"


PAPER_CHOICES: dict[str, tuple[str, ...]] = {
    "reading": get_args(ReadingName), "right_angle": get_args(RightAngle), "ties": get_args(Ties),
    "teeth": get_args(Teeth), "tall": get_args(Tall)}


def paper_options(chosen: Mapping[str, str]) -> PaperOptions:
    """Return the options with the given names and values, the others at their defaults.

    Raises `InputError` for a name or value that is not in `PAPER_CHOICES`.
    """
    for name, value in chosen.items():
        if value not in PAPER_CHOICES.get(name, ()):
            raise InputError(f"{name}={value} is none of the paper's choices")
    return replace(PaperOptions(), **chosen)  # type: ignore[arg-type]  # the values were looked up above


@dataclass(frozen=True, slots=True)
class PaperConstruction:
    """The result of every step, in the input's own units, and the finished mesh."""

    options: PaperOptions
    mfs_squared: mpq
    shape: Shape
    curve: OffsetCurve
    p4: Offset
    trapezoidation: Trapezoidation
    interior: Patch
    tube: PaperTube
    mesh: Mesh

    @property
    def points(self) -> tuple[Point, ...]:
        """All vertices: those of P, P4, the chord ends, those of the Interior and of the Tube."""
        return (self.shape.points + self.p4.points + self.trapezoidation.points + self.interior.points
                + self.tube.patch.points)


def construct_paper(subdivision: Subdivision, mfs_squared: mpq, options: PaperOptions = PaperOptions(),
                    progress: Callable[[str], None] = lambda step: None) -> PaperConstruction:
    """Return the published construction on one simple polygon; nothing is repaired, so the mesh may fail any claim.

    Raises `InputError` when the domain is not one simple polygon.
    """
    shape = simple_polygon(subdivision)
    progress("P2, P3")
    curve = offset_curve(shape, mfs_squared, options.right_angle)
    progress("P4")
    granularity = READINGS[options.reading].granularity
    p4 = snap(shape, curve, grid_spacing(mfs_squared, granularity), options.ties)
    progress("P5")
    chords = trapezoidate(p4)
    points = [*shape.points, *p4.points, *chords.points]
    progress("P6")
    interior = triangulate_with_centres(chords, points)
    points += interior.points
    progress("Tube")
    tube = triangulate_tube_in_phases(shape, p4, chords, points, mfs_squared, TubeOptions(
        granularity, options.teeth, options.tall, options.rectangle))
    points += tube.patch.points
    kind: Kind = "proper" if options.rectangle == "layers" else "nonproper"
    mesh = Mesh(kind, tuple(points), interior.faces + tube.patch.faces)
    return PaperConstruction(options, mfs_squared, shape, curve, p4, chords, interior, tube, mesh)


def simple_polygon(subdivision: Subdivision) -> Shape:
    """Return the domain as one walk, in the input's own units; raises `InputError` when it is more than that."""
    pslg = subdivision.pslg
    domain = subdivision.domain
    if (len(domain) != 1 or len(subdivision.faces) != 2 or len(domain[0].walks) != 1 or domain[0].isolated
            or len(domain[0].walks[0]) != len(pslg.edges) or len(pslg.vertices) != len(pslg.edges)):
        raise InputError("the paper's construction is for one simple polygon; this input is more than that")
    return Shape(mpq(1), pslg.vertices, subdivision.half_edges.origin, (domain[0].walks,), ((),), ())
