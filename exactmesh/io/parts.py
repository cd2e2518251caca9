"""A PSLG as polygons with holes, lines and points: what GeoJSON, WKT and their kin can say.

Each face of the domain is a polygon. Edges that bound none are lines, and vertices on no edge points. Reading the
parts back (`exactmesh.io.rings`) gives the same PSLG but for the order of its vertices and edges, the name, and
where the hole points stand.
"""

from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point, cross, minus
from exactmesh.planar.faces import Face, Subdivision, subdivide
from exactmesh.planar.pslg import Pslg

Ring = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Parts:
    """Indices of vertices. A polygon is its exterior ring, counter-clockwise, and the rings of its holes, clockwise.

    Rings are open: the first vertex is not repeated.
    """

    polygons: tuple[tuple[Ring, ...], ...]
    lines: tuple[tuple[int, int], ...]
    points: tuple[int, ...]


def parts_of(pslg: Pslg) -> Parts:
    """Return the parts of `pslg`; raises `GeometryError` when it is none."""
    subdivision = subdivide(pslg)
    polygons = tuple(_polygon(subdivision, face) for face in subdivision.domain)
    drawn = {frozenset(side) for polygon in polygons for ring in polygon
             for side in zip(ring, (*ring[1:], ring[0]), strict=True)}
    lines = tuple(edge for edge in pslg.edges if frozenset(edge) not in drawn)
    on_edges = {v for edge in pslg.edges for v in edge}
    return Parts(polygons, lines, tuple(v for v in range(len(pslg.vertices)) if v not in on_edges))


def _polygon(subdivision: Subdivision, face: Face) -> tuple[Ring, ...]:
    half_edges = subdivision.half_edges
    own = {h for walk in face.walks for h in walk}
    rings = []
    for walk in face.walks:
        # An edge with the face on both sides bounds nothing; what is left falls apart where it meets itself.
        rings += _simple_rings([half_edges.origin[h] for h in walk if h ^ 1 not in own])
    # The face is connected: one ring goes around it, all others around what it leaves out.
    return tuple(sorted(rings, key=lambda ring: _doubled_area(subdivision.pslg, ring) < 0))


def _simple_rings(walk: list[int]) -> list[Ring]:
    """Return the rings, none through a vertex twice, that a closed walk is made of."""
    rings: list[Ring] = []
    path: list[int] = []
    place: dict[int, int] = {}
    for v in [*walk, *walk[:1]]:
        if v in place:
            ring = path[place[v] :]
            rings.append(tuple(ring))
            del path[place[v] :]
            for u in ring:
                del place[u]
        place[v] = len(path)
        path.append(v)
    return rings


def _doubled_area(pslg: Pslg, ring: Ring) -> mpq:
    points = [minus(pslg.vertices[v], pslg.vertices[ring[0]]) for v in ring]
    return sum((cross(a, b) for a, b in pairwise(points)), mpq(0))


def closed(ring: Ring, points: tuple[Point, ...]) -> list[Point]:
    """Return the points of a ring, the first repeated at the end."""
    return [points[v] for v in (*ring, ring[0])]
