"""The faces of a PSLG, and which of them are the domain to be meshed.

A face is bounded by walks of half-edges with the face on their left: at most one outer walk, counter-clockwise, and
inner ones around what lies inside; and it may hold isolated vertices.
"""

from dataclasses import dataclass
from functools import cmp_to_key

from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.geometry.point import Point, cross, minus
from exactmesh.planar.half_edges import HalfEdges, link, outgoing, walks
from exactmesh.planar.pslg import Pslg
from exactmesh.planar.validate import Swept, swept


class HoleOutside(GeometryError):
    """A hole point lies in the unbounded face, which is never meshed."""

    def __init__(self, hole: int, at: Point) -> None:
        super().__init__(f"hole point {hole} at {at} lies outside: no bounded face contains it")
        self.hole, self.at = hole, at


class NoDomain(GeometryError):
    """There is no bounded face, or holes take them all."""


@dataclass(frozen=True, slots=True)
class Face:
    """`outer` is None for the unbounded face only; walks are tuples of half-edges, `isolated` are vertices."""

    outer: tuple[int, ...] | None
    inner: tuple[tuple[int, ...], ...]
    isolated: tuple[int, ...]
    is_hole: bool = False

    @property
    def walks(self) -> tuple[tuple[int, ...], ...]:
        """All walks, the outer one first."""
        return ((self.outer,) if self.outer else ()) + self.inner


@dataclass(frozen=True, slots=True)
class Subdivision:
    """A validated PSLG with its half-edges and faces; face 0 is the unbounded one."""

    pslg: Pslg
    half_edges: HalfEdges
    faces: tuple[Face, ...]

    @property
    def domain(self) -> tuple[Face, ...]:
        """The bounded faces that no hole point marks."""
        return tuple(face for face in self.faces[1:] if not face.is_hole)


def subdivide(pslg: Pslg) -> Subdivision:
    """Validate `pslg` and return its faces.

    Raises the errors of `exactmesh.planar.validate.validate`, and `HoleOutside`.
    """
    sweep = swept(pslg)
    half_edges = link(pslg.edges, _rotation(pslg, sweep))
    faces = _faces(pslg, half_edges, sweep)
    sweep.turns.note()
    return Subdivision(pslg, half_edges, faces)


def domain_of(pslg: Pslg) -> Subdivision:
    """Return `subdivide(pslg)`; raises `NoDomain` when there is nothing to mesh."""
    subdivision = subdivide(pslg)
    if not subdivision.domain:
        some = len(subdivision.faces) > 1
        raise NoDomain("every bounded face holds a hole point: nothing is left to mesh" if some else
                       "the edges enclose nothing: there is no bounded face to mesh")
    return subdivision


def _rotation(pslg: Pslg, sweep: Swept) -> list[list[int]]:
    """Return the half-edges that leave each vertex, counter-clockwise."""
    rotation = outgoing(pslg.edges, len(pslg.vertices))
    edges, rank, orientation = pslg.edges, sweep.rank, sweep.turns.orientation

    def target(h: int) -> int:
        return edges[h >> 1][1 - (h & 1)]

    for v, leaving in enumerate(rotation):
        if len(leaving) < 3:
            continue

        def counter_clockwise(h: int, k: int, v: int = v) -> int:
            a, b = target(h), target(k)
            # Those to the right come first, from below; two on one side are less than half a turn apart.
            if (rank[a] > rank[v]) != (rank[b] > rank[v]):
                return -1 if rank[a] > rank[v] else 1
            return -orientation(v, a, b)

        leaving.sort(key=cmp_to_key(counter_clockwise))
    return rotation


def doubled_walk_area(pslg: Pslg, half_edges: HalfEdges, walk: tuple[int, ...]) -> mpq:
    """Return twice the signed area that a walk of half-edges encloses; positive counter-clockwise."""
    points = pslg.vertices
    start = points[half_edges.origin[walk[0]]]
    return sum((cross(minus(points[half_edges.origin[h]], start), minus(points[half_edges.target(h)], start))
                for h in walk), mpq(0))


def _is_outer(half_edges: HalfEdges, walk: tuple[int, ...], sweep: Swept) -> bool:
    """Return whether a walk goes around a bounded face on its left, and not around what lies inside a face.

    Decided at its first vertex v in lexicographic order. A face that has the walk around something on its left reaches
    beyond v to the left there, between two successive half-edges; a bounded face inside the walk does not. All
    half-edges of the walk leave v to the right, less than half a turn apart, so it is a matter of one turn.
    """
    rank, origin, orientation = sweep.rank, half_edges.origin, sweep.turns.orientation
    v = min((origin[h] for h in walk), key=rank.__getitem__)
    before = walk[-1]
    for h in walk:
        if origin[h] == v and orientation(v, half_edges.target(h), origin[before]) <= 0:
            return False
        before = h
    return True


def _faces(pslg: Pslg, half_edges: HalfEdges, sweep: Swept) -> tuple[Face, ...]:
    below, rank = sweep.below, sweep.rank
    all_walks = walks(half_edges)
    walk_of = [0] * len(half_edges.origin)
    for index, walk in enumerate(all_walks):
        for h in walk:
            walk_of[h] = index
    is_outer = [_is_outer(half_edges, walk, sweep) for walk in all_walks]
    face_of_walk = [0] * len(all_walks)
    outer: list[tuple[int, ...] | None] = [None]
    for index, walk in enumerate(all_walks):
        if is_outer[index]:
            face_of_walk[index] = len(outer)
            outer.append(walk)
    inner: list[list[tuple[int, ...]]] = [[] for _ in outer]
    isolated: list[list[int]] = [[] for _ in outer]

    def face_above(edge: int) -> int:
        if edge < 0:
            return 0
        u, v = pslg.edges[edge]
        return face_of_walk[walk_of[2 * edge if rank[u] < rank[v] else 2 * edge + 1]]

    def leftmost(walk: tuple[int, ...]) -> int:
        return min((half_edges.origin[h] for h in walk), key=rank.__getitem__)

    # From left to right: the edge below a walk's first vertex belongs to a walk whose face is known by then.
    inner_walks = [(leftmost(walk), index) for index, walk in enumerate(all_walks) if not is_outer[index]]
    for first, index in sorted(inner_walks, key=lambda item: rank[item[0]]):
        face_of_walk[index] = face_above(below.vertex[first])
        inner[face_of_walk[index]].append(all_walks[index])
    on_edges = {v for edge in pslg.edges for v in edge}
    for v in range(len(pslg.vertices)):
        if v not in on_edges:
            isolated[face_above(below.vertex[v])].append(v)
    holes = set()
    for index, edge in enumerate(below.hole):
        face = face_above(edge)
        if face == 0:
            raise HoleOutside(index, pslg.holes[index])
        holes.add(face)
    return tuple(Face(outer[f], tuple(inner[f]), tuple(isolated[f]), f in holes) for f in range(len(outer)))
