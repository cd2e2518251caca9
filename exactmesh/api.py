"""What the command line does, as functions: read a PSLG, measure it, mesh it, verify a mesh."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from gmpy2 import mpq

from exactmesh.claims.claim import Judgement
from exactmesh.claims.ledger import judge
from exactmesh.claims.run import ConstructionName, Run, construction_for
from exactmesh.io.read import read_pslg
from exactmesh.measure.ifs import internal_feature_size
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.numbers.rational import sqrt_text
from exactmesh.optimize.optimize import Optimized, optimize
from exactmesh.pictures import plot as pictures
from exactmesh.planar.faces import domain_of, subdivide
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg, polygon

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Progress = Callable[[str], None]
pictures.attach(Pslg, Mesh)

__all__ = ["Mesh", "Meshing", "Pslg", "ifs", "mesh", "meshing_of", "mfs", "optimized", "plot", "polygon", "read",
           "verify"]


def _silent(step: str) -> None:
    """Report nothing."""


@dataclass(frozen=True, slots=True)
class Meshing:
    """A mesh with the verdicts on all claims of its construction, and its verification.

    Lengths in the verdicts are in units of the input's mfs. `run` has every step of the construction.
    """

    mesh: Mesh
    judgements: tuple[Judgement, ...]
    verification: Verification
    run: Run = field(repr=False, compare=False)

    @property
    def holds(self) -> bool:
        """Whether every claim holds."""
        return all(judgement.verdict.holds for judgement in self.judgements)

    def plot(self, ax: "Axes | None" = None, step: str = "mesh") -> "Axes":
        """Draw a step of the construction on matplotlib axes, as `plot` does."""
        return pictures.plot(self.run, ax, step)

    def _repr_html_(self) -> str:
        squared = self.verification.degradation_squared
        degradation = "not valid" if squared is None else f"degradation {sqrt_text(squared, 6)}"
        fails = sum(not judgement.verdict.holds for judgement in self.judgements)
        size = f"{self.mesh.kind} mesh of {len(self.mesh.faces)} faces"
        return pictures.notebook_html(
            self.run, f"{size}, {degradation}; {len(self.judgements)} claims, {fails or 'none'} failed")


def read(path: str) -> Pslg:
    """Return the PSLG in a file of any known format, `-` for standard input.

    Raises `InputError` when the file cannot be read or is not what it claims to be. Whether the features meet only
    where they may is decided by the functions below.
    """
    return read_pslg(path).pslg


def mfs(pslg: Pslg) -> Nearest | None:
    """Return the squared minimum feature size of `pslg`, exactly, with its witness; None when there is no pair.

    Raises `InputError` when edges cross or overlap, a vertex lies on an edge, or vertices coincide.
    """
    subdivide(pslg)
    return minimum_feature_size(pslg)


def ifs(pslg: Pslg) -> Nearest | None:
    """Return the squared internal feature size of the domain of `pslg`, exactly, with its witness.

    It counts distances inside the faces only. None without a domain. Raises `InputError` as `mfs` does.
    """
    return internal_feature_size(subdivide(pslg))


def mesh(pslg: Pslg, construction: ConstructionName | None = None, kind: Kind = "nonproper",
         progress: Progress = _silent, optimal: bool = False) -> Meshing:
    """Return a triangulation of the bounded faces of `pslg`, less holes.

    A nonproper one by the repaired construction has degradation at most 21.6, a proper one at most
    max(21.6, 9 (1 + log2 n)) for n corners; an internal one keeps the internal feature size up to a factor of 45, may
    split edges of the input, and is made where every edge has the domain on one side; a classic one adds no vertex and
    promises nothing (`optimal`: the best one of one simple polygon). "paper" is the published construction, for one
    simple polygon; "coarse" the repaired one in a balance designed for 17.3, which some inputs break, for nonproper
    meshes; when none is named the kind decides.

    Every step is checked exactly and the mesh is verified; what fails is told by `Meshing.judgements`, not raised.
    `progress` is called with the name of each step. Raises `InputError` when `pslg` is none, encloses nothing, or is
    not for the construction.
    """
    return meshing_of(Run(pslg, construction or construction_for(kind), kind, progress=progress, optimal=optimal))


def meshing_of(run: Run) -> Meshing:
    """Return the mesh of a run with the verdicts on all claims that concern it; raises what `mesh` raises."""
    return Meshing(run.mesh, tuple(judge(run)), run.verification, run)


def optimized(pslg: Pslg, kind: Kind = "nonproper", target: mpq | int = 1, time_limit: float | None = None,
              progress: Progress = _silent) -> Optimized:
    """Return a mesh of `pslg` of small degradation, improved locally; never worse than `mesh` of that kind.

    No vertex is put on an edge of the input. It ends at degradation `target`, at a local optimum, or after an effort
    linear in the input; with a `time_limit` in seconds when the time is up; or at a `KeyboardInterrupt`, with the best
    mesh so far. Raises `InputError` for kinds other than "nonproper" and "proper", and as `mesh` does.
    """
    return optimize(domain_of(pslg), kind, target, time_limit, progress)


def verify(pslg: Pslg, mesh: Mesh) -> Verification:
    """Return whether `mesh` is a valid mesh of its kind of `pslg`, and its exact feature size and degradation.

    Uses no construction. Raises `InputError` when `pslg` is none or encloses nothing.
    """
    return verify_mesh(domain_of(pslg), mesh)


def plot(thing: Pslg | Mesh | Meshing, ax: "Axes | None" = None, step: str | None = None) -> "Axes":
    """Draw an input, a mesh or a step of a construction on matplotlib axes, new ones unless given; return the axes.

    `step` is one of `exactmesh plot --step`, of a `Meshing` only. Raises `InputError` without matplotlib (the extra
    "plot"), and for a step that the construction does not have.
    """
    return pictures.plot(thing.run if isinstance(thing, Meshing) else thing, ax, step)
