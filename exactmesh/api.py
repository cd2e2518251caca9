"""What the command line does, as functions: read a PSLG, measure it, mesh it, verify a mesh."""

from collections.abc import Callable
from dataclasses import dataclass

from exactmesh.claims.claim import Judgement, Run
from exactmesh.claims.repaired import judge
from exactmesh.io.read import read_pslg
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.faces import domain_of, subdivide
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import construct

Progress = Callable[[str], None]


def _silent(step: str) -> None:
    """Report nothing."""


@dataclass(frozen=True, slots=True)
class Meshing:
    """A mesh with the verdicts on all claims of its construction, and its verification.

    Lengths in the verdicts are in units of the input's mfs.
    """

    mesh: Mesh
    judgements: tuple[Judgement, ...]
    verification: Verification

    @property
    def holds(self) -> bool:
        """Whether every claim holds."""
        return all(judgement.verdict.holds for judgement in self.judgements)


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


def mesh(pslg: Pslg, progress: Progress = _silent) -> Meshing:
    """Return a nonproper triangulation of the bounded faces of `pslg`, less holes, with degradation below 21.6.

    Every step is checked exactly and the mesh is verified; what fails is told by `Meshing.judgements`, not raised.
    `progress` is called with the name of each step. Raises `InputError` when `pslg` is none or encloses nothing.
    """
    progress("validation")
    subdivision = domain_of(pslg)
    progress("mfs")
    nearest = minimum_feature_size(pslg)
    if nearest is None:
        raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
    construction = construct(subdivision, nearest.squared, progress)
    progress("verification")
    verification = verify_mesh(subdivision, construction.mesh)
    run = Run(subdivision, nearest, construction, verification)
    return Meshing(construction.mesh, tuple(judge(run, progress)), verification)


def verify(pslg: Pslg, mesh: Mesh) -> Verification:
    """Return whether `mesh` is a valid mesh of its kind of `pslg`, and its exact feature size and degradation.

    Uses no construction. Raises `InputError` when `pslg` is none or encloses nothing.
    """
    return verify_mesh(domain_of(pslg), mesh)
