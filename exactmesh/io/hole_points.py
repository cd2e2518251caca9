"""A hole point for every bounded face that no polygon covers.

A face lies inside a ring when a path to it from the unbounded face crosses the ring an odd number of times,
and inside a polygon when it lies inside its exterior ring (an odd number of them, where rings are of equal
standing) and no interior one. Faces are those of the whole PSLG, so a hole that islands or lines divide gets a
point in each part, and one that another polygon fills gets none.
"""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

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
                 for face, is_covered in zip(subdivision.faces, _are_covered(subdivision, rings), strict=True)
                 if face.outer is not None and not is_covered)


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


def _are_covered(subdivision: Subdivision, rings: Sequence[Ring]) -> list[bool]:
    """Return, for each face, whether a polygon covers it.

    The faces are walked along a tree, to and fro: only the rings around the face at hand are known, as the rings
    around all faces may be as many as the square of what there is.
    """
    crossed: dict[int, set[int]] = {}
    for index, ring in enumerate(rings):
        for edge in ring.edges:
            # Symmetric difference: a ring that runs along an edge twice is not crossed there.
            crossed.setdefault(edge, set()).symmetric_difference_update({index})
    face_of = {h: f for f, face in enumerate(subdivision.faces) for walk in face.walks for h in walk}
    around = _Around(rings)
    covered: list[bool | None] = [False, *[None] * (len(subdivision.faces) - 1)]

    def ways(face: int) -> Iterator[int]:
        return chain.from_iterable(subdivision.faces[face].walks)

    # Each face on the way from the unbounded one, with the ways out that are left and the edge one came in by.
    path = [(ways(0), -1)]
    while path:
        left, entered = path[-1]
        h = next((h for h in left if covered[face_of[h ^ 1]] is None), None)
        if h is None:
            path.pop()
            around.cross(crossed.get(entered, ()))
        else:
            around.cross(crossed.get(h >> 1, ()))
            covered[face_of[h ^ 1]] = around.covering > 0
            path.append((ways(face_of[h ^ 1]), h >> 1))
    return [bool(is_covered) for is_covered in covered]


class _Around:
    """The rings around one face, and how many polygons cover it."""

    def __init__(self, rings: Sequence[Ring]) -> None:
        self.rings = rings
        self.inside: set[int] = set()
        self.exteriors: Counter[int] = Counter()
        self.interiors: Counter[int] = Counter()
        self.covering = 0

    def cross(self, crossed: Collection[int]) -> None:
        """Go over an edge of these rings."""
        for index in crossed:
            ring = self.rings[index]
            self.covering -= self._covers(ring.polygon)
            counts = self.exteriors if ring.is_exterior else self.interiors
            counts[ring.polygon] += -1 if index in self.inside else 1
            self.inside ^= {index}
            self.covering += self._covers(ring.polygon)

    def _covers(self, polygon: int) -> bool:
        return self.exteriors[polygon] % 2 == 1 and self.interiors[polygon] == 0


def _vertices_on(pslg: Pslg, ring: Ring) -> int:
    return len({v for edge in ring.edges for v in pslg.edges[edge]})
