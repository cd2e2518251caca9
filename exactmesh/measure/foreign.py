"""Meshes made elsewhere: put in our order, verified, and measured even when they are not quite meshes of the input.

Meshers number vertices as they like, turn faces either way, and round. What they made is compared with the input by
exact coordinates.
"""

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.geometry.point import Point, cross, minus
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.cycles import sides
from exactmesh.planar.faces import Subdivision, subdivide
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg


@dataclass(frozen=True, slots=True)
class Size:
    """The feature size of what may be no plane graph: `crossing` says why then, and `nearest` is None."""

    nearest: Nearest | None
    crossing: str = ""


@dataclass(frozen=True, slots=True)
class Foreign:
    """The measure of a mesh from elsewhere.

    `graph` is the feature size of the graph of its edges. `missing` are input vertices on no face. `on_boundary`
    counts the vertices that a mesh has on its boundary, or on edges of the input, beyond the input's.
    """

    mesh: Mesh
    verification: Verification
    graph: Size
    missing: tuple[int, ...]
    on_boundary: int

    @property
    def degradation_squared(self) -> mpq | None:
        """The exact square of mfs(input) / mfs(graph of the mesh), whether it is a mesh of the input or not."""
        given = self.verification.input_mfs
        found = self.graph.nearest
        return None if found is None or given is None else given.squared / found.squared


def measure_foreign(subdivision: Subdivision, vertices: Sequence[Point], faces: Sequence[tuple[int, ...]]) -> Foreign:
    """Return the measure of a mesh of the domain of `subdivision`, given by vertices and cycles in any order."""
    pslg = subdivision.pslg
    points, cycles, missing = in_order(pslg, vertices, faces)
    on_edges = _on_edges(pslg, points)
    mesh = Mesh(_kind(pslg, points, cycles, on_edges), points, cycles)
    verification = verify_mesh(subdivision, mesh)
    graph = Size(verification.mesh_mfs) if verification.valid else graph_mfs(points, cycles)
    rim = Counter(frozenset(side) for cycle in cycles for side in sides(cycle))
    ends = {v for side, count in rim.items() if count == 1 for v in side if v >= len(pslg.vertices)}
    return Foreign(mesh, verification, graph, missing, len(ends | on_edges))


def graph_mfs(points: Sequence[Point], cycles: Sequence[tuple[int, ...]]) -> Size:
    """Return the feature size of the graph of all sides of faces, its vertices by their indices in `points`."""
    edges = {(min(side), max(side)) for cycle in cycles for side in sides(cycle) if side[0] != side[1]}
    used = sorted({v for edge in edges for v in edge})
    number = {v: i for i, v in enumerate(used)}
    size = pslg_mfs(Pslg(tuple(points[v] for v in used), tuple((number[u], number[v]) for u, v in sorted(edges))))
    if size.nearest is None:
        return size
    a, b = size.nearest.feature
    return Size(Nearest(size.nearest.squared, used[size.nearest.vertex], (used[a], used[b])))


def pslg_mfs(pslg: Pslg) -> Size:
    """Return the feature size of what may be no PSLG."""
    try:
        subdivide(pslg)
    except GeometryError as error:
        return Size(None, str(error))
    return Size(minimum_feature_size(pslg))


def in_order(pslg: Pslg, vertices: Sequence[Point], faces: Sequence[tuple[int, ...]]
              ) -> tuple[tuple[Point, ...], tuple[tuple[int, ...], ...], tuple[int, ...]]:
    """Return points with the input's first, counter-clockwise cycles, and the input vertices on no face."""
    index = {point: v for v, point in enumerate(pslg.vertices)}
    points = list(pslg.vertices)
    number: dict[int, int] = {}
    for v in dict.fromkeys(v for face in faces for v in face):
        known = index.get(vertices[v])
        if known is None:
            # Repeated vertices stay repeated: that is for the verifier to say.
            known = len(points)
            points.append(vertices[v])
        number[v] = known
    cycles = []
    for face in faces:
        cycle = tuple(number[v] for v in face)
        start = points[cycle[0]]
        area = sum((cross(minus(points[a], start), minus(points[b], start)) for a, b in sides(cycle)), mpq(0))
        cycles.append(cycle if area >= 0 else cycle[::-1])
    used = set(number.values())
    return tuple(points), tuple(cycles), tuple(v for v in range(len(pslg.vertices)) if v not in used)


def _kind(pslg: Pslg, points: tuple[Point, ...], cycles: tuple[tuple[int, ...], ...], on_edges: set[int]) -> Kind:
    if any(len(cycle) > 3 for cycle in cycles):
        return "nonproper"
    if on_edges:
        return "internal"
    return "classic" if len(points) == len(pslg.vertices) else "proper"


def _on_edges(pslg: Pslg, points: tuple[Point, ...]) -> set[int]:
    """Return the vertices beyond the input's that lie on its edges."""
    found = set()
    ordered = sorted(range(len(pslg.vertices), len(points)), key=lambda v: points[v])
    xs = [points[v].x for v in ordered]
    for u, w in pslg.edges:
        a, b = sorted((pslg.vertices[u], pslg.vertices[w]))
        for v in ordered[bisect_left(xs, a.x) : bisect_right(xs, b.x)]:
            p = points[v]
            if min(a.y, b.y) <= p.y <= max(a.y, b.y) and orientation(a, b, p) == 0:
                found.add(v)
    return found
