"""A hole point for every bounded face that no polygon covers.

A face lies inside a ring when a path to it from the unbounded face crosses the ring an odd number of times,
and inside a polygon when it lies inside the exterior ring and no interior one. Faces are those of the whole
PSLG, so a hole that islands or lines divide gets a point in each part, and one that another polygon fills
gets none.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import Face, Subdivision, subdivide
from exactmesh.planar.pslg import Pslg


@dataclass(frozen=True, slots=True)
class Ring:
    """A closed walk of edges of the PSLG that bounds `polygon` from outside or, as a hole's, from inside."""

    polygon: int
    is_exterior: bool
    edges: tuple[int, ...]


def hole_points(pslg: Pslg, rings: Sequence[Ring]) -> tuple[Point, ...]:
    """Return a point strictly inside each bounded face that no polygon covers, for a PSLG without holes.

    A graph that is not planar has no faces; it gets no hole points, and `validate` is left to refuse it.
    """
    if len(rings) == 1 and len(set(rings[0].edges)) == len(pslg.edges) == _vertices_on(pslg, rings[0]):
        # One ring that passes no vertex twice: when it is planar, it has one bounded face, which it covers.
        return ()
    try:
        subdivision = subdivide(pslg)
    except GeometryError:
        return ()
    return tuple(point_inside(subdivision, face)
                 for face, inside in zip(subdivision.faces, _rings_around(subdivision, rings), strict=True)
                 if face.outer is not None and not _is_covered(inside, rings))


def point_inside(subdivision: Subdivision, face: Face) -> Point:
    """Return a point strictly inside a bounded face.

    It lies on the vertical line through the middle of an edge of the outer walk, halfway to what that line
    meets next; all that it can meet within the face is on the face's own walks, or an isolated vertex.
    """
    points, half_edges = subdivision.pslg.vertices, subdivision.half_edges
    outer = face.outer or ()
    # Not all edges of a walk that encloses an area are vertical.
    h = next(h for h in outer if points[half_edges.origin[h]].x != points[half_edges.target(h)].x)
    a, b = points[half_edges.origin[h]], points[half_edges.target(h)]
    x, y = (a.x + b.x) / 2, (a.y + b.y) / 2
    # The face is on the left of the half-edge: above it, if that leads to the right.
    heights = _heights(subdivision, face, x)
    met = min(t for t in heights if t > y) if a.x < b.x else max(t for t in heights if t < y)
    return Point(x, (y + met) / 2)


def _heights(subdivision: Subdivision, face: Face, x: mpq) -> Iterator[mpq]:
    """Yield the ordinates at which the line at abscissa `x` meets a face's walks and isolated vertices."""
    points, half_edges = subdivision.pslg.vertices, subdivision.half_edges
    for v in face.isolated:
        if points[v].x == x:
            yield points[v].y
    for walk in face.walks:
        for h in walk:
            a, b = points[half_edges.origin[h]], points[half_edges.target(h)]
            if a.x == x:
                yield a.y
            elif (a.x < x) != (b.x < x) and b.x != x:
                yield a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)


def _rings_around(subdivision: Subdivision, rings: Sequence[Ring]) -> list[frozenset[int]]:
    """Return, for each face, the rings it lies inside."""
    crossed: dict[int, frozenset[int]] = {}
    for index, ring in enumerate(rings):
        for edge in ring.edges:
            # Symmetric difference: a ring that runs along an edge twice is not crossed there.
            crossed[edge] = crossed.get(edge, frozenset()) ^ {index}
    face_of = {h: f for f, face in enumerate(subdivision.faces) for walk in face.walks for h in walk}
    around: dict[int, frozenset[int]] = {0: frozenset()}
    pending = [0]
    while pending:
        face = pending.pop()
        for walk in subdivision.faces[face].walks:
            for h in walk:
                beyond = face_of[h ^ 1]
                if beyond not in around:
                    around[beyond] = around[face] ^ crossed.get(h >> 1, frozenset())
                    pending.append(beyond)
    return [around[face] for face in range(len(subdivision.faces))]


def _is_covered(inside: frozenset[int], rings: Sequence[Ring]) -> bool:
    excluded = {rings[index].polygon for index in inside if not rings[index].is_exterior}
    return any(rings[index].is_exterior and rings[index].polygon not in excluded for index in inside)


def _vertices_on(pslg: Pslg, ring: Ring) -> int:
    return len({v for edge in ring.edges for v in pslg.edges[edge]})
