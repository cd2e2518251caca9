"""Check the offset Q from what it has to be; `offset.py` and the offset body are not imported.

I1 thickness    each end of an offset edge is at a distance between g and 0.4701 from its edge's line, on the inside.
I2 separation   a vertex of Q keeps 0.0599 from every edge of Q that does not contain it.
I3 nesting      Q is a set of simple rings on levels, one a walk, turned like it and inside its face.
"""

from collections.abc import Sequence

import numpy as np
from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.geometry.columns import Columns, Rows, indices
from exactmesh.geometry.decisions import note
from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.geometry.predicates import doubled_area
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.verdict import Tally, Verdict, Witness, failed
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.validate import validate
from exactmesh.steps.constants import LEVEL, SEPARATION, THICKNESS_MAX
from exactmesh.steps.filtered_tally import see_worst
from exactmesh.steps.records import Offset, Shape


def check_thickness(shape: Shape, offset: Offset, columns: Columns | None = None) -> tuple[Verdict, Verdict]:
    """Return the verdicts on the least and on the greatest squared thickness (I1), one instance an end of an edge.

    An end on the wrong side of its edge counts with a negative square. `columns` begin with the vertices of P and Q;
    to give them saves time, here and below.
    """
    least = Tally("distance to the edge >= g", ">=", LEVEL**2)
    greatest = Tally("distance to the edge <= 0.4701", "<=", THICKNESS_MAX**2)
    points = columns or Columns(shape.points + offset.points)
    origin, source = indices(shape.origin), indices(offset.source)
    k = np.flatnonzero(source >= 0)
    half_edge = np.repeat(source[k], 2)
    a, b = origin[half_edge], origin[half_edge ^ 1]
    end = np.column_stack((k, indices(offset.successors())[k])).ravel() + len(shape.points)
    area = points.doubled_areas(a, b, end)
    values = area * area.sizes() / points.distances_squared(a, b)

    def exactly(i: int) -> mpq:
        p, q = points[a[i]], points[b[i]]
        size = doubled_area(p, q, points[end[i]])
        return size * abs(size) / distance_squared(p, q)

    def place(i: int) -> dict[str, object]:
        return {"edge": int(half_edge[i]) >> 1, "at": str(points[end[i]])}

    for tally in (least, greatest):
        see_worst(tally, "offset thickness", values, exactly, place)
    return least.verdict(), greatest.verdict()


def check_separation(offset: Offset) -> Verdict:
    """Return the verdict on the least squared distance between a vertex of Q and an edge without it (I2)."""
    q = Pslg(offset.points, _edges(offset))
    tally = Tally("distance >= 0.0599", ">=", SEPARATION**2)
    nearest = minimum_feature_size(q)
    if nearest is None:
        return tally.verdict()
    tally.see(nearest.squared, at=str(q.vertices[nearest.vertex]), edge_of_q=list(nearest.feature))
    verdict = tally.verdict()
    return Verdict(len(offset.points), verdict.holds, verdict.worst, verdict.witness)


def check_nesting(shape: Shape, offset: Offset, columns: Columns | None = None, spacing: mpq = LEVEL) -> Verdict:
    """Return whether Q is a set of simple rings on levels, one a walk, turned like it and inside its face (I3).

    P, Q and one spoke a ring, from a corner of the walk to its vertex of Q, are checked to be a planar graph; the
    spoke must leave the corner within its angle. A ring that crosses nothing of P is then inside the face. Levels are
    `spacing` apart.
    """
    height = {level: (level + mpq(1, 2)) * spacing for level in set(offset.level)}
    for k, point in enumerate(offset.points):
        if (point.x, point.y) != (offset.x[k], height[offset.level[k]]):
            return failed(k + 1, "vertices are on levels", vertex_of_q=k, at=str(point))
    walks = [walk for face, _ in zip(shape.faces, shape.isolated, strict=True) for walk in face]
    corners = {frozenset(walk): walk for walk in walks}
    alone = {-1 - v for isolated in shape.isolated for v in isolated}
    spokes: list[Edge] = []
    points = columns or Columns(shape.points + offset.points)
    rings = [range(offset.first + start, offset.first + end) for start, end in offset.rings]
    ring_turns_left = _turn_left(points, rings)
    walk_turns_left = dict(zip(map(frozenset, walks), _turn_left(
        points, [[shape.origin[h] for h in walk] for walk in walks]), strict=True))
    for number, (start, end) in enumerate(offset.rings):
        around = list(dict.fromkeys(offset.corner[start:end]))
        walk = corners.pop(frozenset(around), None)
        if walk is None and (len(around) != 1 or around[0] not in alone):
            return failed(number + 1, "a ring belongs to one walk, once", ring=number)
        alone.discard(around[0])
        if ring_turns_left[number] != (walk is not None and walk_turns_left[frozenset(walk)]):
            return failed(number + 1, "a ring turns like its walk", ring=number)
        spoke = _spoke(shape, offset, walk, start)
        if spoke is None:
            return failed(number + 1, "a ring is inside its face", ring=number, at=str(offset.points[start]))
        spokes.append(spoke)
    if corners or alone:
        return failed(len(offset.rings), "every walk has a ring", missing=len(corners) + len(alone))
    shifted = tuple((u + offset.first, v + offset.first) for u, v in _edges(offset))
    p_edges = tuple((shape.origin[h], shape.origin[h + 1]) for h in range(0, len(shape.origin), 2))
    try:
        validate(Pslg(shape.points + offset.points, p_edges + shifted + tuple(spokes)))
    except GeometryError as error:
        return Verdict(len(offset.points), False, None, Witness("Q is simple and meets nothing", {"what": str(error)}))
    return Verdict(len(offset.points), True)


def _edges(offset: Offset) -> tuple[Edge, ...]:
    return tuple(enumerate(offset.successors()))


def _spoke(shape: Shape, offset: Offset, walk: tuple[int, ...] | None, k: int) -> Edge | None:
    """Return the edge from the corner of vertex k of Q to that vertex; None when it leaves the corner's angle."""
    corner, q = offset.corner[k], offset.points[k]
    if walk is None:
        return -1 - corner, offset.first + k
    before = walk[walk.index(corner) - 1]
    p = shape.points[shape.origin[corner]]
    to_next, to_last = shape.points[shape.origin[corner ^ 1]], shape.points[shape.origin[before]]
    inside = _is_within(minus(to_next, p), minus(to_last, p), minus(q, p))
    return (shape.origin[corner], offset.first + k) if inside else None


def _is_within(start: Point, end: Point, direction: Point) -> bool:
    """Return whether a direction lies strictly within the angle counter-clockwise from `start` to `end`.

    Equal directions make a full turn.
    """
    after_start, before_end = bool(cross(start, direction) > 0), bool(cross(direction, end) > 0)
    turn = cross(start, end)
    if turn > 0:
        return after_start and before_end
    if turn == 0 and dot(start, end) < 0:
        return after_start
    # Straight on from the end of a slit is after and before nothing, but within its full turn.
    return after_start or before_end or (turn == 0 and dot(start, direction) < 0)


def _turn_left(points: Columns, cycles: Sequence[Sequence[int]]) -> list[bool]:
    """Return whether closed walks enclose a positive area, counted with its sign."""
    if not all(cycles):
        return [bool(cycle) and _turn_left(points, [cycle])[0] for cycle in cycles]
    if not cycles:
        return []
    rows = Rows(cycles)
    begin = rows.start[:-1]
    last = np.arange(len(rows.flat)) - 1
    last[begin] = rows.start[1:] - 1
    first = np.repeat(rows.flat[begin], rows.size)
    areas = points.doubled_areas(first, rows.flat[last], rows.flat).sums(begin)
    signs = areas.signs().tolist()
    note("ring", len(cycles), signs.count(0))
    return [sign > 0 if sign else _doubled_area([points[v] for v in cycle]) > 0
            for sign, cycle in zip(signs, cycles, strict=True)]


def _doubled_area(ring: Sequence[Point]) -> mpq:
    return sum((doubled_area(ring[0], ring[i - 1], ring[i]) for i in range(2, len(ring))), mpq(0))
