"""Meshers compared: the exact degradation of what they make of the same inputs, and what they put on the boundary.

The inputs are rounded to doubles first, which is what the other meshers read. Their results are doubles too, that is
rational numbers: each is measured as it is. First it is asked whether it is exactly a mesh of the input, by the
clauses of `exactmesh.measure.validity`; vertices on the input's edges are then allowed. Where rounding has moved such
vertices off the edges it is none; then its edges are measured as a planar graph by themselves, if they are one.

Seconds are of processor time: of the mesher alone for the others, with exact verification for exactmesh. Not judged:
angles, sizes, and whatever else these meshers are made for.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from time import process_time

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.optimize.optimize import optimize
from exactmesh.planar.cycles import directed_edges
from exactmesh.planar.faces import Subdivision, domain_of, subdivide
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import construct
from exactmesh.reproduce.peer_inputs import Input, inputs
from exactmesh.reproduce.peer_tools import PEERS, Outline, Output, Tool, Workshop

GUARANTEED, OPTIMIZED = "exactmesh", "exactmesh --optimize"


@dataclass(frozen=True, slots=True)
class Measured:
    """What a mesh is worth: `degradation_squared` is None where it is not even a planar graph.

    `is_mesh`: it is exactly a mesh of the input. `boundary`: added vertices on the boundary of the meshed region, or
    exactly on edges of the input.
    """

    is_mesh: bool
    degradation_squared: mpq | None
    steiner: int
    boundary: int
    faces: int


@dataclass(frozen=True, slots=True)
class PeerRow:
    """One mesher on one input with n vertices; `measured` is None when `status` is not "made"."""

    group: str
    name: str
    n: int
    tool: str
    status: str
    message: str
    seconds: float
    measured: Measured | None


def peer_rows(short: bool = False, progress: Callable[[str], None] = lambda step: None,
              chosen: Sequence[Input] | None = None, tools: Sequence[Tool] = PEERS) -> Iterator[PeerRow]:
    """Yield the rows, input by input; `progress` is told each."""
    with Workshop(peers=tools) as workshop:
        for given in inputs(short) if chosen is None else chosen:
            pslg = rounded(given.make())
            subdivision = domain_of(pslg)
            size = minimum_feature_size(pslg)
            if size is None:
                raise AssertionError("a bounded face has three vertices, hence a vertex-edge pair")
            outline = outline_of(subdivision)

            def row(tool: str, output: Output, measured: Measured | None, given: Input = given,
                    n: int = len(pslg.vertices)) -> PeerRow:
                return PeerRow(given.group, given.name, n, tool, output.status, output.message, output.seconds,
                               measured)

            for number, tool in enumerate(tools):
                progress(f"{given.group}, {given.name}: {tool.name}")
                output = workshop.mesh(number, outline)
                yield row(tool.name, output, measure(subdivision, size.squared, output)
                          if output.status == "made" else None)
            progress(f"{given.group}, {given.name}: exactmesh")
            start = process_time()
            verification = verify_mesh(subdivision, construct(subdivision, size.squared).mesh)
            yield row(GUARANTEED, Output("made", "", process_time() - start), _ours(verification))
            start = process_time()
            verification = optimize(subdivision).verification
            yield row(OPTIMIZED, Output("made", "", process_time() - start), _ours(verification))


def rounded(pslg: Pslg) -> Pslg:
    """Return the PSLG with all coordinates rounded to doubles."""
    def point(p: Point) -> Point:
        return Point(mpq(float(p.x)), mpq(float(p.y)))

    return Pslg(tuple(map(point, pslg.vertices)), pslg.edges, tuple(map(point, pslg.holes)), pslg.name)


def outline_of(subdivision: Subdivision) -> Outline:
    """Return the domain in doubles."""
    pslg, origin = subdivision.pslg, subdivision.half_edges.origin
    rings = [[[origin[h] for h in walk] for walk in face.walks] for face in subdivision.domain]
    corners = [[v for ring in face for v in ring] for face in rings]
    are_simple = all(len(set(names)) == len(names) for names in corners)
    are_simple = are_simple and not any(face.isolated for face in subdivision.domain)
    return Outline([(float(x), float(y)) for x, y in pslg.vertices], list(pslg.edges),
                   [(float(x), float(y)) for x, y in pslg.holes], rings if are_simple else None)


def measure(subdivision: Subdivision, size_squared: mpq, output: Output) -> Measured:
    """Return what a mesher's output is worth as a mesh of the domain, whose squared mfs is `size_squared`."""
    pslg = subdivision.pslg
    points, faces = _renamed(pslg, output)
    given = len(pslg.vertices)
    boundary = _on_boundary(pslg, points, faces)
    mesh = Mesh("internal" if boundary else "proper", points, faces)
    verification = verify_mesh(subdivision, mesh)
    squared = verification.degradation_squared
    if squared is None:
        squared = _graph_degradation(size_squared, points, faces)
    return Measured(verification.valid, squared, len(points) - given, boundary, len(faces))


def _ours(verification: Verification) -> Measured:
    return Measured(verification.valid, verification.degradation_squared, verification.steiner, 0, verification.faces)


def _renamed(pslg: Pslg, output: Output) -> tuple[tuple[Point, ...], tuple[tuple[int, int, int], ...]]:
    """Return the output's points and counter-clockwise faces, the input's vertices first and as they were given.

    Points on no face are left out, and those with the coordinates of an input vertex are that vertex.
    """
    index = {point: v for v, point in enumerate(pslg.vertices)}
    points = list(pslg.vertices)
    used = {v for triangle in output.triangles for v in triangle}
    name: dict[int, int] = {}
    for v, (x, y) in enumerate(output.vertices):
        if v in used:
            point = Point(mpq(x), mpq(y))
            if point not in index:
                index[point] = len(points)
                points.append(point)
            name[v] = index[point]
    faces = []
    for triangle in output.triangles:
        u, v, w = (name[corner] for corner in triangle)
        faces.append((u, v, w) if orientation(points[u], points[v], points[w]) >= 0 else (u, w, v))
    return tuple(points), tuple(faces)


def _on_boundary(pslg: Pslg, points: Sequence[Point], faces: Iterable[tuple[int, int, int]]) -> int:
    """Return how many added vertices lie on sides of one face only, or on the input's edges exactly."""
    given = len(pslg.vertices)
    owner, _ = directed_edges(faces)
    found = {v for side in owner if side[::-1] not in owner for v in side if v >= given}
    known = {frozenset(edge) for edge in pslg.edges}
    neighbours: dict[int, set[int]] = {}
    for u, v in owner:
        neighbours.setdefault(u, set()).add(v)
        neighbours.setdefault(v, set()).add(u)
    for u, end in pslg.edges:
        # An edge with faces on both sides may have been split: walk along it as far as its parts lie on it exactly.
        at, last = u, -1
        while frozenset((at, end)) not in known or end not in neighbours.get(at, ()):
            onward = [v for v in neighbours.get(at, ()) if v >= given and v != last
                      and orientation(points[u], points[end], points[v]) == 0
                      and min(points[at], points[end]) < points[v] < max(points[at], points[end])]
            if not onward or end in neighbours.get(at, ()):
                break
            last, at = at, onward[0]
            found.add(at)
    return len(found)


def _graph_degradation(size_squared: mpq, points: tuple[Point, ...], faces: Iterable[tuple[int, int, int]]
                       ) -> mpq | None:
    """Return the squared degradation of the faces' edges as a graph by themselves; None when they are no PSLG."""
    edges = sorted({(min(u, v), max(u, v)) for face in faces for u, v in zip(face, (*face[1:], face[0]), strict=True)})
    used = sorted({v for edge in edges for v in edge})
    name = {v: i for i, v in enumerate(used)}
    if not edges or any(u == v for u, v in edges):
        return None
    graph = Pslg(tuple(points[v] for v in used), tuple((name[u], name[v]) for u, v in edges))
    try:
        subdivide(graph)
    except InputError:
        return None
    nearest = minimum_feature_size(graph)
    return None if nearest is None else size_squared / nearest.squared
