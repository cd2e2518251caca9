"""Decide whether a mesh is a valid mesh of a PSLG, from the definitions, for meshes of any origin.

The clauses, each O(size) once the faces of the input are known:

kind             the kind is one of the four
face-index       each face lists vertices of the mesh (when one does not, nothing else is looked at)
input-vertices   the input's vertices come first, unchanged
repeated-vertex  no two vertices of the mesh coincide
face-shape       each face is geometrically a triangle, its cycle counter-clockwise
face-size        faces have three vertices (`classic`, `proper`, `internal`)
steiner          there is no Steiner vertex (`classic`)
overlap          no directed edge belongs to two faces
input-edge       an edge of the input with the domain on its left is an edge of a face (`internal`: a chain of them)
boundary         just those edges have a face on one side only that are (`internal`: parts of) edges of the input with
                 the domain on that side only
unused-vertex    each vertex is on a face, but for input vertices away from the domain

Why they suffice: by face-shape to boundary, the sum of the boundaries of the faces is the boundary of the domain, so
the sum of their indicator functions is its winding number, 1 inside and 0 outside. The faces tile the domain and do
not overlap; hence no edges cross, and a vertex on a face's side that the face does not list would leave edges
without a twin, against `boundary`.
"""

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import chain

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.fixed_point import FixedPoints, Ints, stretches
from exactmesh.geometry.predicates import is_ahead, orientation
from exactmesh.measure.face_feature import face_witness
from exactmesh.measure.ifs import internal_feature_size, mesh_ifs_of
from exactmesh.measure.mesh_faces import MeshFaces, Sides
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.planar.cycles import Side
from exactmesh.planar.cycles import sides as cycle_sides
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import KINDS, Mesh
from exactmesh.planar.pslg import Pslg


@dataclass(frozen=True, slots=True)
class Violation:
    """A clause that fails, and where: indices by name."""

    clause: str
    place: Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Verification:
    """The verdict on a mesh. `mesh_mfs` is None when the mesh is not valid: it then has no feature size to speak of.

    The internal feature sizes are there for valid meshes of kind "internal" only.
    """

    kind: str
    violations: tuple[Violation, ...]
    input_mfs: Nearest | None
    mesh_mfs: Nearest | None
    steiner: int
    faces: int
    input_ifs: Nearest | None = None
    mesh_ifs: Nearest | None = None

    @property
    def valid(self) -> bool:
        """Whether no clause is violated."""
        return not self.violations

    @property
    def degradation_squared(self) -> mpq | None:
        """The exact square of mfs(input) / mfs(mesh); None when the mesh is not valid."""
        if self.mesh_mfs is None or self.input_mfs is None:
            return None
        return self.input_mfs.squared / self.mesh_mfs.squared

    @property
    def ifs_degradation_squared(self) -> mpq | None:
        """The exact square of ifs(input) / ifs(mesh) of a valid internal mesh."""
        if self.mesh_ifs is None or self.input_ifs is None:
            return None
        return self.input_ifs.squared / self.mesh_ifs.squared


def verify_mesh(subdivision: Subdivision, mesh: Mesh, input_mfs: Nearest | None = None) -> Verification:
    """Return whether `mesh` is a valid mesh of its kind of the domain of `subdivision`, and its exact feature size.

    To give the input's `minimum_feature_size`, where it is known, saves the search for it.
    """
    pslg = subdivision.pslg
    judge = _Judge(subdivision, mesh)
    judge.run()
    input_mfs = input_mfs or minimum_feature_size(pslg)
    mesh_mfs = None if judge.violations else _mesh_mfs(subdivision, mesh, input_mfs, judge)
    steiner = len(mesh.vertices) - len(pslg.vertices)
    input_ifs = internal_feature_size(subdivision) if mesh.kind == "internal" and not judge.violations else None
    return Verification(mesh.kind, tuple(judge.violations), input_mfs, mesh_mfs, steiner, len(mesh.faces),
                        input_ifs, mesh_ifs_of(mesh, judge.faces) if input_ifs is not None else None)


class _Judge:
    """Collects violations clause by clause; `faces` are there once all indices are known to be in range."""

    def __init__(self, subdivision: Subdivision, mesh: Mesh) -> None:
        self.subdivision = subdivision
        self.mesh = mesh
        self.violations: list[Violation] = []
        self.columns = FixedPoints(mesh.vertices)
        half_edges = subdivision.half_edges
        self.origin = np.array(half_edges.origin, dtype=np.int64)
        self.along = np.fromiter((h for face in subdivision.domain for walk in face.walks for h in walk), np.int64)

    def run(self) -> None:
        if self.mesh.kind not in KINDS:
            self._violated("kind", kind=self.mesh.kind)
        self._check_indices()
        if self.violations:
            return
        self.faces = MeshFaces(self.columns, self.mesh.faces)
        self._check_vertices()
        self._check_faces()
        self._check_edges()
        self._check_use()

    def _violated(self, clause: str, **place: object) -> None:
        self.violations.append(Violation(clause, place))

    def _check_indices(self) -> None:
        count, faces = len(self.mesh.vertices), self.mesh.faces
        try:
            flat = np.fromiter(chain.from_iterable(faces), np.int64)
        except OverflowError:
            flat = np.array([-1])
        if not flat.size or (flat.min() >= 0 and flat.max() < count):
            return
        for number, cycle in enumerate(faces):
            for v in cycle:
                if not 0 <= v < count:
                    self._violated("face-index", face=number, vertex=v)

    def _check_vertices(self) -> None:
        given, mesh = self.subdivision.pslg.vertices, self.mesh
        if mesh.vertices[: len(given)] != given:
            for v, point in enumerate(given):
                if v >= len(mesh.vertices) or mesh.vertices[v] != point:
                    self._violated("input-vertices", vertex=v, at=str(point))
        if mesh.kind == "classic" and len(mesh.vertices) > len(given):
            self._violated("steiner", vertex=len(given))
        for v, other in self.columns.coincident():
            self._violated("repeated-vertex", vertex=v, other=other, at=str(mesh.vertices[v]))

    def _check_faces(self) -> None:
        refused = dict(self.faces.not_triangles())
        size = np.diff(self.faces.start)
        wrong_size = np.flatnonzero(size != 3).tolist() if self.mesh.kind != "nonproper" else ()
        for number in sorted({*refused, *wrong_size}):
            if (reason := refused.get(number)) is not None:
                self._violated("face-shape", face=number, vertex=reason.vertex, reason=reason.reason)
            else:
                self._violated("face-size", face=number, vertices=int(size[number]))

    def _check_edges(self) -> None:
        faces = self.faces
        sides = faces.sides()
        origin, target = faces.vertex, faces.vertex[faces.following]
        for entry, owner in zip(sides.repeated.tolist(), sides.owner.tolist(), strict=True):
            self._violated("overlap", edge=[int(origin[entry]), int(target[entry])], face=int(faces.face[entry]),
                           other=int(faces.face[owner]))
        on_rim = np.zeros(len(origin), np.bool_)
        on_rim[sides.find(self._rim(sides))] = True
        for part in stretches(len(sides.first)):
            first = sides.first[part]
            twin = sides.find(faces.key(target[first], origin[first]))
            # An edge without a twin must be on the rim, one on the rim must have none.
            wrong = on_rim[first] == (twin >= 0)
            for entry, other in zip(first[wrong].tolist(), twin[wrong].tolist(), strict=True):
                shown = entry if other < 0 else other
                self._violated("boundary", edge=[int(origin[shown]), int(target[shown])], face=int(faces.face[shown]))

    def _rim(self, sides: Sides) -> Ints:
        """Return the keys of the mesh edges along the input with the domain on their left and not on their right.

        The edges of faces that must lie along the input are looked for on the way.
        """
        count = len(self.mesh.vertices)
        origin, target = self.origin[self.along], self.origin[self.along ^ 1]
        # Input vertices may be missing in the mesh: their numbers make no key.
        known = (origin < count) & (target < count)
        key = origin * count + target
        found = known & (sides.find(key) >= 0)
        outside = np.ones(len(self.origin), np.bool_)
        outside[self.along] = False
        on_rim = outside[self.along ^ 1]
        rim = [key[found & on_rim]]
        leaving: dict[int, list[int]] = defaultdict(list)
        if self.mesh.kind == "internal" and not found.all():
            faces = self.faces
            for entry in sides.first.tolist():
                leaving[int(faces.vertex[entry])].append(int(faces.vertex[faces.following[entry]]))
        for place in np.flatnonzero(~found).tolist():
            u, v = int(origin[place]), int(target[place])
            parts = self._chain((u, v), leaving)
            if not parts:
                self._violated("input-edge", edge=[u, v])
            elif on_rim[place]:
                rim.append(np.array([a * count + b for a, b in parts], dtype=np.int64))
        return np.concatenate(rim)

    def _chain(self, side: Side, leaving: Mapping[int, list[int]]) -> list[Side]:
        """Return the mesh edges that make up one side of an input edge; none when some part is missing."""
        points = self.mesh.vertices
        u, end = side
        if end >= len(points) or u >= len(points):  # input vertices are missing
            return []
        parts: list[Side] = []
        while u != end:
            onward = [v for v in leaving.get(u, ()) if v == end or (
                orientation(points[u], points[v], points[end]) == 0 and is_ahead(points[u], points[v], points[end]))]
            if not onward:
                return []
            parts.append((u, onward[0]))
            u = onward[0]
        return parts

    def _check_use(self) -> None:
        count, given = len(self.mesh.vertices), len(self.subdivision.pslg.vertices)
        missing = np.ones(count, np.bool_)
        missing[self.faces.vertex] = False
        needed = np.zeros(max(count, given), np.bool_)
        needed[given:] = True
        needed[self.origin[self.along]] = True
        needed[[v for face in self.subdivision.domain for v in face.isolated]] = True
        for v in np.flatnonzero(missing & needed[:count]).tolist():
            self._violated("unused-vertex", vertex=v)


def _mesh_mfs(subdivision: Subdivision, mesh: Mesh, input_mfs: Nearest | None, judge: _Judge) -> Nearest | None:
    """Return the mfs of a valid mesh: the least of its faces' and of what the faces that are not meshed see.

    Where no input edge is split, the latter is at least the input's mfs, and all the input's pairs are pairs of the
    mesh. An `internal` mesh may split the boundary, so all of its edges are looked at.
    """
    if mesh.kind == "internal":
        pslg = subdivision.pslg
        edges = {(min(side), max(side)) for cycle in mesh.faces for side in cycle_sides(cycle)}
        domain = {h >> 1 for face in subdivision.domain for walk in face.walks for h in walk}
        edges |= {edge for e, edge in enumerate(pslg.edges) if e not in domain}
        return minimum_feature_size(Pslg(mesh.vertices, tuple(sorted(edges))))
    least = judge.faces.least_feature()
    if least is None or (input_mfs is not None and input_mfs.squared <= least[0]):
        return input_mfs
    return face_witness(mesh.vertices, mesh.faces[least[1]])
