"""Optimise a mesh of a domain: the least degradation first, then few Steiner vertices, no vertex on the input's edges.

The first candidate is the constrained Delaunay triangulation, improved. Where the mesh of the repaired construction may
be better, it is made and compared, so the result is never worse than either. Where the best is still poor and there is
time, or the construction's is the best, its proper mesh is improved as well. The finished mesh is verified from its
definition.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import inf
from time import monotonic
from typing import Literal

from gmpy2 import is_square, isqrt, mpq

from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.numbers.rational import sqrt_below
from exactmesh.optimize.faces import Faces
from exactmesh.optimize.improve import Effort, Improver, Reason, thin_out
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.repaired import construct
from exactmesh.steps.constants import THICKNESS_MAX

Start = Literal["constrained Delaunay", "repaired construction"]
OPTIMIZED_KINDS: tuple[Kind, ...] = ("nonproper", "proper")

# Every vertex of the offset polygon is this near to an edge of the input, in units of at most the mfs; so no mesh of
# the repaired construction keeps more, but for bare triangles, which every candidate has.
_CONSTRUCTION_AT_MOST = THICKNESS_MAX
# A degradation above this is poor: some long combs end up better from the construction's proper mesh.
_POOR = mpq(3)
# After thinning out there may be room for more: improve and thin out at most so often.
_ROUNDS = 3
_UNIT_BITS = 24
_SHORT_BITS = 64


@dataclass(frozen=True, slots=True)
class Candidate:
    """A mesh on the way: its squared degradation, Steiner vertices and faces."""

    name: str
    degradation_squared: mpq
    steiner: int
    faces: int


@dataclass(frozen=True, slots=True)
class Optimized:
    """The optimised mesh with its verification, what it was made from, and why the work ended.

    `reason` is "target" when the degradation asked for is reached, "no move helps" at a local optimum, "effort" when
    little was gained by much work, "time" at the time limit, "interrupted" by the user.
    """

    mesh: Mesh
    verification: Verification
    start: Start
    reason: Reason
    candidates: tuple[Candidate, ...]
    steps: int


def optimize(subdivision: Subdivision, kind: Kind = "nonproper", target: mpq | int = 1,
             time_limit: float | None = None, progress: Callable[[str], None] = lambda step: None) -> Optimized:
    """Return a mesh of the domain with small degradation: never above the constrained Delaunay triangulation's, nor
    the repaired construction's of that kind (unless interrupted, as below).

    The work ends at degradation `target`, or when no move helps, or after an effort that grows linearly with the
    input. With a `time_limit` in seconds the clock takes the place of that effort; the repaired construction, where
    it is needed, is finished all the same. A `KeyboardInterrupt` ends the work early: the mesh as it is by then is
    verified and returned. Only before there is any mesh, or a second time, it is passed on.

    The mesh is of kind "proper" where it is one. Raises `InputError` for another kind or a target below 1.
    """
    if kind not in OPTIMIZED_KINDS:
        raise InputError(f"meshes of kind {' and '.join(OPTIMIZED_KINDS)} are optimised, not {kind} ones")
    if target < 1:
        raise InputError("no mesh that keeps the input's edges whole has a degradation below 1")
    return _Work(subdivision, kind, mpq(target), time_limit, progress).run()


class _Work:
    """One optimisation. Coordinates are relative to the input's first vertex, in units of about its mfs."""

    def __init__(self, subdivision: Subdivision, kind: Kind, target: mpq, time_limit: float | None,
                 progress: Callable[[str], None]) -> None:
        self.subdivision, self.kind, self.progress = subdivision, kind, progress
        nearest = minimum_feature_size(subdivision.pslg)
        if nearest is None:
            raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
        self.size = nearest.squared
        self.unit = unit_near(nearest.squared)
        # In units: the squared mfs of the input, and what is aimed at.
        self.mfs_squared = nearest.squared / self.unit**2
        self.goal = self.mfs_squared / target**2
        count = len(subdivision.pslg.vertices)
        self.has_time = time_limit is not None
        end = inf if time_limit is None else monotonic() + time_limit
        self.effort = Effort(200 + 3 * count if time_limit is None else inf,
                             100 + count / 8 if time_limit is None else inf, lambda: monotonic() > end)
        self.candidates: list[Candidate] = []
        self.start: Start = "constrained Delaunay"

    def run(self) -> Optimized:
        pslg = self.subdivision.pslg
        self.progress("constrained Delaunay triangulation")
        first = constrained_delaunay(self.subdivision)
        self.constrained = first.constrained
        self.best = self.faces(pslg.vertices, first.triangles)
        self.reason = self.improved(self.start, self.best)
        try:
            # The effort is spent; what is left to do is the guarantee, and more where there is time.
            if self.reason != "interrupted" and self.is_below(_CONSTRUCTION_AT_MOST):
                self.compare_construction()
            if self.reason != "interrupted" and self.is_below(1 / _POOR) and (
                    self.has_time or self.start == "repaired construction"):
                self.improve_construction()
        except KeyboardInterrupt:
            self.reason = "interrupted"
        mesh = self.mesh(self.best)
        self.progress("verification")
        return Optimized(mesh, verify_mesh(self.subdivision, mesh), self.start, self.reason, tuple(self.candidates),
                         self.best.steps)

    def is_below(self, share: mpq) -> bool:
        """Return whether the best mesh keeps less than `share` of the input's mfs."""
        return bool(self.kept(self.best) < share**2 * self.mfs_squared)

    def improve_construction(self) -> None:
        """Improve the proper mesh of the construction, too: T-vertices leave the moves little room."""
        seed = self.constructed("proper")
        if seed is not None:
            self.consider(seed, self.improved("repaired construction, proper", seed))

    def compare_construction(self) -> None:
        """See whether the mesh of the construction is better as it is."""
        made = self.constructed(self.kind)
        if made is not None:
            self.note(f"repaired construction, {self.kind}", made)
            self.consider(made, self.reason)

    def constructed(self, kind: Kind) -> Faces | None:
        """Return the mesh of the repaired construction; None when it fails."""
        try:
            mesh = construct(self.subdivision, self.size, self.progress, kind).mesh
        except ConstructionFailed:
            return None
        return self.faces(mesh.vertices, mesh.faces)

    def consider(self, other: Faces, reason: Reason) -> None:
        """Take another mesh for the best where it is better."""
        if self.kept(other) > self.kept(self.best):
            self.best, self.start, self.reason = other, "repaired construction", reason
        elif reason == "interrupted":
            self.reason = reason

    def improved(self, name: str, faces: Faces) -> Reason:
        """Improve the faces in place, thin them out, and again; an interrupt is taken for the end."""
        self.note(name, faces)
        try:
            improver = Improver(faces, self.goal, self.effort, self.progress)
            for _ in range(_ROUNDS):
                reason = improver.run()
                before = faces.steps
                self.progress("optimisation: thinning out")
                thin_out(faces, self.kept(faces), self.effort.is_late)
                if reason in ("target", "time") or faces.steps == before:
                    break
        except KeyboardInterrupt:
            faces.settle()
            reason = "interrupted"
        self.note(f"{name}, optimised", faces)
        return reason

    def kept(self, faces: Faces) -> mpq:
        """Return the squared mfs of the mesh: the least of its faces' and the input's."""
        return min(self.mfs_squared, faces.feature[faces.worst()])

    def note(self, name: str, faces: Faces) -> None:
        """Keep the figures of a candidate."""
        steiner = sum(1 for v, around in faces.around.items() if around and v >= faces.given)
        self.candidates.append(Candidate(name, self.mfs_squared / self.kept(faces), steiner, len(faces.cycle)))

    def faces(self, vertices: Iterable[Point], cycles: Iterable[Cycle]) -> Faces:
        """Return the faces of a mesh in units."""
        pslg, unit = self.subdivision.pslg, self.unit
        origin = pslg.vertices[0]
        points = [Point((p.x - origin.x) / unit, (p.y - origin.y) / unit) for p in vertices]
        return Faces(points, len(pslg.vertices), self.constrained, cycles)

    def mesh(self, faces: Faces) -> Mesh:
        """Return the mesh in the input's coordinates; the input's vertices as they were given."""
        pslg, unit = self.subdivision.pslg, self.unit
        origin = pslg.vertices[0]
        used = sorted(v for v, around in faces.around.items() if around and v >= faces.given)
        name = {v: i for i, v in enumerate([*range(faces.given), *used])}
        added = tuple(Point(faces.point[v].x * unit + origin.x, faces.point[v].y * unit + origin.y) for v in used)
        cycles = []
        for cycle in faces.cycle.values():
            renamed = [name[v] for v in cycle]
            first = renamed.index(min(renamed))
            cycles.append((*renamed[first:], *renamed[:first]))
        kind: Kind = "proper" if all(len(cycle) == 3 for cycle in cycles) else "nonproper"
        return Mesh(kind, pslg.vertices + added, tuple(sorted(cycles)))


def unit_near(squared: mpq) -> mpq:
    """Return the square root of `squared` > 0 where it is a short rational, else a short one just below it.

    A unit that is the mfs puts places that are simple relative to the input on the grids of the optimiser.
    """
    p, q = squared.numerator, squared.denominator
    if max(p.bit_length(), q.bit_length()) <= 2 * _SHORT_BITS and is_square(p) and is_square(q):
        return mpq(isqrt(p), isqrt(q))
    return sqrt_below(squared, _UNIT_BITS)
