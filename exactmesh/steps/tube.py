"""Triangulate the Tube between P and Q (in place of paper §2, phases 1 to 4).

In      `Shape`, `Offset`, the vertices recorded on edges of Q, and the points of all vertices so far.
Out     `Patch`.
Exact   rational.
Paper   cuts the Tube into fans and quasi-trapz, those into rectangles and rests. Here each edge of P and its offset
        edge bound one one-sided quadrilateral, whatever its slopes; the cap of a corner is a fan.
Check   `patch_check.py`

No vertex is put on P, on Q or on an edge between them, but for Theorem 3's meshes, which may split P.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from exactmesh.geometry.point import Point, dot, minus
from exactmesh.steps.balance import REPAIRED, Balance
from exactmesh.steps.constants import MERGE
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Patch, Shape


def triangulate_tube(shape: Shape, offset: Offset, on_edge: Sequence[tuple[int, int]], points: Sequence[Point],
                     proper: bool = False, balance: Balance = REPAIRED) -> Patch:
    """Return the triangulation of the Tube; `on_edge` pairs edges of Q with the vertices that lie on them."""
    mesh = PatchBuilder(points, proper, balance)
    for k, chain in enumerate(_chains(offset, on_edge, points)):
        source = offset.source[k]
        if source < 0:
            _add_fan(mesh, shape, offset, k, chain)
        else:
            mesh.add_one_sided(chain, shape.origin[source], shape.origin[source ^ 1])
    return mesh.finished()


def triangulate_tube_in_columns(shape: Shape, offset: Offset, on_edge: Sequence[tuple[int, int]],
                                points: Sequence[Point]) -> Patch:
    """Return a proper triangulation of the Tube that passes the vertices on edges of Q on to edges of P (Theorem 3).

    Each goes straight to the edge of P, or to an end of it that is within `MERGE`; what is left are rows of clean
    quadrilaterals. `on_edge` of the result is empty: its new vertices lie on P.
    """
    mesh = PatchBuilder(points, proper=True)
    for k, chain in enumerate(_chains(offset, on_edge, points)):
        source = offset.source[k]
        if source < 0:
            _add_fan(mesh, shape, offset, k, chain)
            continue
        p, q = shape.origin[source], shape.origin[source ^ 1]
        below = [p, *(_foot(mesh, p, q, v) for v in chain[1:-1]), q]
        for (u, u_foot), (v, v_foot) in pairwise(zip(chain, below, strict=True)):
            mesh.add_quad((u_foot, v_foot, v, u))
    return mesh.finished()


def _foot(mesh: PatchBuilder, p: int, q: int, v: int) -> int:
    """Return the foot of the perpendicular from v on the edge p q; an end of the edge when that is near or before."""
    start, end, place = mesh.points[p], mesh.points[q], mesh.points[v]
    along = minus(end, start)
    length_squared = dot(along, along)
    t = dot(minus(place, start), along) / length_squared
    for end_vertex, left in ((p, t), (q, 1 - t)):
        if left <= 0 or left * left * length_squared <= MERGE**2:
            return end_vertex
    return mesh.add(Point(start.x + t * along.x, start.y + t * along.y))


def _chains(offset: Offset, on_edge: Sequence[tuple[int, int]], points: Sequence[Point]) -> Iterator[tuple[int, ...]]:
    """Yield, for each edge of Q, its vertices in order: its ends and those recorded on it."""
    following_of = offset.successors()
    recorded: list[list[int]] = [[] for _ in following_of]
    for edge, v in on_edge:
        recorded[edge].append(v)
    for k, following in enumerate(following_of):
        start, end = offset.first + k, offset.first + following
        # On a line, points are in lexicographic order.
        between = sorted(recorded[k], key=points.__getitem__, reverse=points[end] < points[start])
        yield (start, *between, end)


def _add_fan(mesh: PatchBuilder, shape: Shape, offset: Offset, k: int, chain: Sequence[int]) -> None:
    """Join the corner of a cap to an edge of the cap."""
    corner = offset.corner[k]
    apex = shape.origin[corner] if corner >= 0 else -1 - corner
    for u, v in pairwise(chain):
        mesh.add_triangle(apex, u, v)
