"""The feature size of one face: a triangle with T-vertices on its sides.

A shortest segment between a vertex and a feature that does not contain it crosses no edge of a planar graph, so it
lies in one face. The mfs of a mesh is therefore the least feature size of its faces, meshed or not.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area, is_ahead
from exactmesh.measure.mfs import Nearest
from exactmesh.planar.cycles import Cycle, sides


@dataclass(frozen=True, slots=True)
class NotTriangle:
    """Why a cycle is no counter-clockwise triangle, and the vertex where this shows."""

    reason: str
    vertex: int


def corners_of(points: Sequence[Point], cycle: Cycle) -> list[int] | NotTriangle:
    """Return the places in `cycle` of the three corners of a counter-clockwise triangle.

    All other vertices must go straight on. The turns of a cycle add up to whole turns, and a left turn is less than
    half of one. So there are three at least; and three, with no other, make one turn, so that the cycle is a simple
    triangle.
    """
    if len(cycle) < 3:
        return NotTriangle("has fewer than three vertices", cycle[0] if cycle else -1)
    places = []
    count = len(cycle)
    for i in range(count):
        a, b, c = points[cycle[i - 1]], points[cycle[i]], points[cycle[(i + 1) % count]]
        turn = doubled_area(a, b, c)
        if turn > 0:
            places.append(i)
        elif turn < 0:
            return NotTriangle("turns right", cycle[i])
        elif not is_ahead(a, b, c):
            return NotTriangle("turns back, or stands still,", cycle[i])
        if len(places) > 3:
            return NotTriangle("has a fourth corner", cycle[i])
    return places


def face_feature_squared(points: Sequence[Point], cycle: Cycle, corners: Sequence[int]) -> mpq:
    """Return the squared feature size of the face: its least height, the distances of T-vertices from the two other
    sides, and those of neighbours on a side with T-vertices. `corners` are the places of the corners in `cycle`."""
    i, j, k = corners
    a, b, c = points[cycle[i]], points[cycle[j]], points[cycle[k]]
    area = doubled_area(a, b, c)
    longest = max(distance_squared(a, b), distance_squared(b, c), distance_squared(c, a))
    least = area * area / longest
    if len(cycle) > 3:
        least = min(least, *(distance_squared(points[u], points[v]) for u, v in sides(cycle)))
        for places, (p, q, r) in ((range(i + 1, j), (b, c, a)), (range(j + 1, k), (c, a, b)),
                                  (range(k + 1, i + len(cycle)), (a, b, c))):
            for place in places:
                t = points[cycle[place % len(cycle)]]
                least = min(least, segment_distance_squared(t, p, q), segment_distance_squared(t, q, r))
    return least


def face_witness(points: Sequence[Point], cycle: Cycle) -> Nearest:
    """Return the nearest vertex-edge pair of one face, by trying all of them."""
    found = [Nearest(segment_distance_squared(points[v], points[a], points[b]), v, (a, b))
             for v in cycle for a, b in sides(cycle) if v not in (a, b)]
    return min(found, key=lambda near: (near.squared, near.vertex, near.feature))
