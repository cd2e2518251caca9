"""Triangulate the Tube between P and Q (in place of paper §2, phases 1 to 4).

In      `Shape`, `Offset`, the vertices recorded on edges of Q, and the points of all vertices so far.
Out     `Patch`.
Exact   rational.
Paper   cuts the Tube into fans and quasi-trapz, those into rectangles and rests. Here each edge of P and its offset
        edge bound one one-sided quadrilateral, whatever its slopes; the cap of a corner is a fan.
Check   `patch_check.py`

No vertex is put on P, on Q or on an edge between them.
"""

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise

from exactmesh.geometry.point import Point, dot, minus
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Patch, Shape


def triangulate_tube(shape: Shape, offset: Offset, on_edge: Sequence[tuple[int, int]], points: Sequence[Point],
                     proper: bool = False) -> Patch:
    """Return the triangulation of the Tube; `on_edge` pairs edges of Q with the vertices that lie on them."""
    mesh = PatchBuilder(points, proper)
    following = offset.successors()
    recorded: dict[int, list[int]] = defaultdict(list)
    for edge, v in on_edge:
        recorded[edge].append(v)
    for k, source in enumerate(offset.source):
        start, end = offset.first + k, offset.first + following[k]
        along = minus(points[end], points[start])
        between = sorted(recorded[k], key=lambda v: dot(minus(points[v], points[start]), along))
        if source < 0:
            corner = offset.corner[k]
            apex = shape.origin[corner] if corner >= 0 else -1 - corner
            for u, v in pairwise((start, *between, end)):
                mesh.add_triangle(apex, u, v)
        else:
            mesh.add_one_sided((start, *between, end), shape.origin[source], shape.origin[source ^ 1])
    return mesh.finished()
