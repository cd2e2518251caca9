"""One input and all that claims may ask of it, computed when it is first asked for."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Literal

from exactmesh.classic import classic_mesh, optimal_classic_mesh
from exactmesh.errors import InputError
from exactmesh.geometry.columns import Columns
from exactmesh.measure.ifs import internal_feature_size
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.measure.verdict import Verdict
from exactmesh.paper import PaperConstruction, PaperOptions, construct_paper, simple_polygon
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import Construction, construct
from exactmesh.steps.balance import COARSE, REPAIRED
from exactmesh.steps.edge_chains import Chains, Misplaced
from exactmesh.steps.offset_check import check_thickness
from exactmesh.steps.offset_curve import offset_curve
from exactmesh.steps.patch_check import PatchColumns, chains_of, check_feature
from exactmesh.steps.records import OffsetCurve
from exactmesh.steps.trapezoidation_check import check_gaps

ConstructionName = Literal["repaired", "paper", "classic", "coarse"]
# Constructions with the steps of the repaired one.
REPAIRED_STEPS: tuple[ConstructionName, ...] = ("repaired", "coarse")


# The paper's Theorem 3 leaves its construction to a sentence that is false of the Interior: there is nothing to run.
KINDS_OF: dict[ConstructionName, tuple[Kind, ...]] = {
    "repaired": ("nonproper", "proper", "internal"), "paper": ("nonproper", "proper"), "classic": ("classic",),
    "coarse": ("nonproper",)}
_DEFAULTS = PaperOptions()


def construction_for(kind: Kind) -> ConstructionName:
    """Return the construction that makes meshes of a kind when none is asked for."""
    return "classic" if kind == "classic" else "repaired"


def _silent(step: str) -> None:
    """Report nothing."""


class Run:
    """An input with a construction; the properties raise what the steps raise, `InputError` for a bad input.

    `progress` is called with the name of each step as it begins. A proper mesh by the paper is Theorem 2's: its
    rectangles are filled in layers. `optimal` asks for the best classic mesh instead of the constrained Delaunay
    triangulation. `jobs` is the number of processes that check. Raises `InputError` when the construction makes no
    meshes of that kind.
    """

    def __init__(self, pslg: Pslg, construction: ConstructionName = "repaired", kind: Kind = "nonproper",
                 options: PaperOptions = _DEFAULTS, progress: Callable[[str], None] = _silent, optimal: bool = False,
                 jobs: int = 1) -> None:
        self.pslg = pslg
        self.construction: ConstructionName = construction
        if kind not in KINDS_OF[construction]:
            *others, last = KINDS_OF[construction]
            made = f"{', '.join(others)} and {last}" if others else last
            raise InputError(f"the {construction} construction makes {made} meshes, not {kind} ones")
        self.kind: Kind = kind
        self.options = replace(options, rectangle="layers") if kind == "proper" else options
        self.progress = progress
        self.optimal = optimal
        self.jobs = jobs

    @cached_property
    def subdivision(self) -> Subdivision:
        """The validated input with its faces."""
        self.progress("validation")
        return domain_of(self.pslg)

    @cached_property
    def mfs(self) -> Nearest:
        """The minimum feature size of the input."""
        nearest = minimum_feature_size(self.subdivision.pslg)
        if nearest is None:
            raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
        return nearest

    @cached_property
    def size(self) -> Nearest:
        """The feature size that the mesh is to keep: the ifs for an internal mesh, else the mfs."""
        if self.kind != "internal":
            return self.mfs
        self.progress("ifs")
        nearest = internal_feature_size(self.subdivision)
        if nearest is None:
            raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
        return nearest

    @cached_property
    def curve(self) -> OffsetCurve:
        """The paper's P2 and P3, without the steps that follow."""
        return offset_curve(simple_polygon(self.subdivision), self.mfs.squared, self.options.right_angle)

    @cached_property
    def repaired(self) -> Construction:
        """The repaired construction, step by step, or the same in the coarse balance."""
        balance = COARSE if self.construction == "coarse" else REPAIRED
        return construct(self.subdivision, self.size.squared, self.progress, self.kind, balance)

    @cached_property
    def columns(self) -> Columns:
        """All points of the repaired construction, for its checkers."""
        return Columns(self.repaired.points)

    @cached_property
    def chains(self) -> Chains | Misplaced:
        """The edges of the repaired construction's Q with all vertices recorded on them."""
        made = self.repaired
        return chains_of(made.offset, made.trapezoidation, made.interior, self.columns)

    @cached_property
    def interior_columns(self) -> PatchColumns:
        """The faces of the repaired construction's Interior, for its checkers."""
        return PatchColumns(self.repaired.interior, self.columns)

    @cached_property
    def tube_columns(self) -> PatchColumns:
        """The faces of the repaired construction's Tube, for its checkers."""
        return PatchColumns(self.repaired.tube, self.columns)

    @cached_property
    def offset_thickness(self) -> tuple[Verdict, Verdict]:
        """The verdicts on the least and on the greatest distance of offset edges from their edges."""
        return check_thickness(self.repaired.shape, self.repaired.offset, self.columns)

    @cached_property
    def chord_gaps(self) -> tuple[Verdict, Verdict, Verdict]:
        """The verdicts on the distances of T-vertices from neighbours, by chords and by edges of Q, and from legs."""
        return check_gaps(self.repaired.offset, self.repaired.trapezoidation, self.columns)

    @cached_property
    def tube_feature(self) -> Verdict:
        """The verdict on the least feature size of the faces of the repaired construction's Tube."""
        return check_feature(self.repaired.tube, self.columns, self.tube_columns)

    @cached_property
    def paper(self) -> PaperConstruction:
        """The paper's construction, step by step."""
        return construct_paper(self.subdivision, self.mfs.squared, self.options, self.progress)

    @cached_property
    def mesh(self) -> Mesh:
        """The finished mesh."""
        if self.construction == "paper":
            return self.paper.mesh
        if self.construction in REPAIRED_STEPS:
            return self.repaired.mesh
        self.progress("triangulation")
        return (optimal_classic_mesh(self.subdivision, self.progress) if self.optimal else
                classic_mesh(self.subdivision))

    @cached_property
    def verification(self) -> Verification:
        """The verification of the mesh."""
        mesh, nearest = self.mesh, self.mfs
        self.progress("verification")
        return verify_mesh(self.subdivision, mesh, nearest)
