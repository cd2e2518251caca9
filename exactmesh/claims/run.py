"""One input and all that claims may ask of it, computed when it is first asked for."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Literal

from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.paper import PaperConstruction, PaperOptions, construct_paper, simple_polygon
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import Construction, construct
from exactmesh.steps.offset_curve import offset_curve
from exactmesh.steps.records import OffsetCurve

ConstructionName = Literal["repaired", "paper"]
MeshKind = Literal["nonproper", "proper"]


_DEFAULTS = PaperOptions()


def _silent(step: str) -> None:
    """Report nothing."""


class Run:
    """An input with a construction; the properties raise what the steps raise, `InputError` for a bad input.

    `progress` is called with the name of each step as it begins. A proper mesh by the paper is Theorem 2's: its
    rectangles are filled in layers.
    """

    def __init__(self, pslg: Pslg, construction: ConstructionName = "repaired", kind: MeshKind = "nonproper",
                 options: PaperOptions = _DEFAULTS, progress: Callable[[str], None] = _silent) -> None:
        self.pslg = pslg
        self.construction: ConstructionName = construction
        self.kind: MeshKind = kind
        self.options = replace(options, rectangle="layers") if kind == "proper" else options
        self.progress = progress

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
    def curve(self) -> OffsetCurve:
        """The paper's P2 and P3, without the steps that follow."""
        return offset_curve(simple_polygon(self.subdivision), self.mfs.squared, self.options.right_angle)

    @cached_property
    def repaired(self) -> Construction:
        """The repaired construction, step by step."""
        return construct(self.subdivision, self.mfs.squared, self.progress, self.kind)

    @cached_property
    def paper(self) -> PaperConstruction:
        """The paper's construction, step by step."""
        return construct_paper(self.subdivision, self.mfs.squared, self.options, self.progress)

    @property
    def mesh(self) -> Mesh:
        """The finished mesh."""
        return self.paper.mesh if self.construction == "paper" else self.repaired.mesh

    @cached_property
    def verification(self) -> Verification:
        """The verification of the mesh."""
        mesh = self.mesh
        self.progress("verification")
        return verify_mesh(self.subdivision, mesh)
