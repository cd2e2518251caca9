"""Check the trapezoidation from what it has to be; `trapezoidation.py` is not imported.

Tiling   each trapezoid is a quadrilateral (or triangle) between two levels with its legs on edges of Q, its sides list
         all vertices on them, and the boundaries of all trapezoids add up to Q: so they tile the inside of Q, and no
         vertex lies inside one.
I4       two neighbouring vertices of Q on one horizontal side, one of them a T-vertex, are 0.15 apart or more along a
         chord, and 0.0688 along an edge of Q, which may have become level; a T-vertex keeps 0.0599 from both legs.
I5       each horizontal side holds a vertex of Q.
I5'      a corner that is no vertex of Q is on an edge of Q that goes on for at least one level beyond it.
"""

from collections.abc import Callable, Sequence
from itertools import chain, pairwise

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import Bools, Ints
from exactmesh.geometry.columns import Columns, Rows, columns_of, indices
from exactmesh.geometry.decisions import note
from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.face_columns import FaceColumns, unpaired_sides
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges
from exactmesh.steps.constants import GAP, LEVEL, LEVEL_EDGE, SEPARATION
from exactmesh.steps.edge_chains import Chains, Misplaced, chain_sides, edge_chains
from exactmesh.steps.filtered_tally import see_worst
from exactmesh.steps.records import Cycle, Offset, Trapezoid, Trapezoidation


def check_tiling(offset: Offset, chords: Trapezoidation, points: Sequence[Point],
                 chains: Chains | Misplaced | None = None) -> Verdict:
    """Return whether the trapezoids tile the inside of Q; one instance a trapezoid.

    `chains` are the edges of Q cut at chord ends and perhaps at later vertices; to give them saves time. Arrays decide
    that all is well; when it is not, the offender is looked for one by one.
    """
    if chains is None or isinstance(chains, Misplaced):
        chains = edge_chains(offset, zip(chords.edge, _chord_ends(chords), strict=True), points)
    if isinstance(chains, Misplaced):
        return failed(0, "a chord end lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)
    count = len(chords.trapezoids)
    following = offset.successors()
    for number in np.flatnonzero(~_are_sound(offset, chords, columns_of(points))).tolist():
        z = chords.trapezoids[number]
        legs = [(points[offset.first + e], points[offset.first + following[e]]) for e in (z.left, z.right)]
        if (clause := _broken(z, legs, points, offset.height)) is not None:
            return failed(number + 1, clause, trapezoid=number, at=str(points[z.bl]))
    cycles = [_cycle(z) for z in chords.trapezoids]
    unpaired = unpaired_sides(FaceColumns(cycles), len(points))
    if unpaired is None:
        _, repeated = directed_edges(cycles)
        return failed(count, "trapezoids do not overlap", trapezoid=repeated[0][1], edge=list(repeated[0][0]))
    end = _chord_ends(chords).stop
    sides = chain_sides([[v for v in chain if v < end] for chain in chains])
    odd = np.setxor1d(unpaired, sides[:, 0] * len(points) + sides[:, 1])
    if odd.size:
        edge = divmod(int(odd[0]), len(points))
        return failed(count, "the trapezoids' boundaries add up to Q", edge=list(edge))
    return Verdict(count, True)


def check_gaps(offset: Offset, chords: Trapezoidation, points: Sequence[Point]
               ) -> tuple[Verdict, Verdict, Verdict]:
    """Return the verdicts on the least squared gaps along a chord and along an edge of Q, and to a leg (I4)."""
    gaps = Tally("gap to a T-vertex >= 0.15", ">=", GAP**2)
    edges = Tally("level edge at a T-vertex >= 0.0688", ">=", LEVEL_EDGE**2)
    legs = Tally("T-vertex to leg >= 0.0599", ">=", SEPARATION**2)
    first, end = offset.first, chords.first
    gap: list[tuple[int, int, int]] = []
    edge: list[tuple[int, int, int]] = []
    following = offset.successors()
    leg: list[tuple[int, int, int, int]] = []
    for number, z in enumerate(chords.trapezoids):
        for left, inner, right in ((z.bl, z.bottom, z.br), (z.tl, z.top, z.tr)):
            if inner:
                for u, v in pairwise((left, *inner, right)):
                    if first <= u < end > v >= first:
                        joined = following[u - first] == v - first or following[v - first] == u - first
                        (edge if joined else gap).append((number, u, v))
                leg += [(number, v, a, b) for v in inner for a, b in ((z.bl, z.tl), (z.br, z.tr))]
    columns = columns_of(points)
    for tally, pairs in ((gaps, gap), (edges, edge)):
        _see_widths(tally, pairs, columns, points)
    _, t, a, b = _table(leg, 4)
    see_worst(legs, "chord leg", columns.segment_distances_squared(t, a, b),
              lambda i: segment_distance_squared(points[t[i]], points[a[i]], points[b[i]]), lambda i: {
                  "trapezoid": leg[i][0], "vertex": leg[i][1], "at": str(points[leg[i][1]])})
    return gaps.verdict(), edges.verdict(), legs.verdict()


def _see_widths(tally: Tally, pairs: Sequence[tuple[int, int, int]], columns: Columns, points: Sequence[Point]) -> None:
    _, u, v = _table(pairs, 3)
    see_worst(tally, "chord gap", (columns.x[v] - columns.x[u]).squared(),
              lambda i: (points[v[i]].x - points[u[i]].x) ** 2, lambda i: {
                  "trapezoid": pairs[i][0], "vertices": list(pairs[i][1:]), "at": str(points[pairs[i][1]])})


def check_touch(offset: Offset, chords: Trapezoidation) -> Verdict:
    """Return whether each horizontal side holds a vertex of Q (I5); the worst is the least number of them."""
    tally = Tally("vertices of Q on a side >= 1", ">=", mpq(1))
    rows = Rows([row for z in chords.trapezoids for row in _sides(z)])
    if len(rows):
        is_of_q = (rows.flat >= offset.first) & (rows.flat < chords.first)
        held = np.add.reduceat(is_of_q, rows.start[:-1], dtype=np.int64)
        least = int(np.argmin(held))
        tally.see(mpq(int(held[least])), trapezoid=least // 2)
        tally.instances = len(held)
    return tally.verdict()


def check_clearance(offset: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on how far, vertically, edges of Q go on beyond chord ends (I5'); one instance an end."""
    tally = Tally("the edge goes on for g or more", ">=", LEVEL)
    columns = columns_of(points)
    edge = indices(chords.edge)
    end = np.column_stack((edge, indices(offset.successors())[edge])).ravel() + offset.first
    v = np.repeat(np.arange(len(edge)) + chords.first, 2)

    def place(i: int) -> dict[str, object]:
        return {"vertex": int(v[i]), "edge_of_q": chords.edge[i // 2], "at": str(points[v[i]])}

    see_worst(tally, "clearance", (columns.y[end] - columns.y[v]).sizes(),
              lambda i: abs(offset.points[end[i] - offset.first].y - points[v[i]].y), place)
    return tally.verdict()


def _table(rows: Sequence[tuple[int, ...]], width: int) -> Ints:
    """Return rows of numbers as columns."""
    return indices(chain.from_iterable(rows), width * len(rows)).reshape(-1, width).T


def _sides(z: Trapezoid) -> tuple[Cycle, Cycle]:
    """Return the vertices on the bottom and on the top from left to right."""
    return (z.bl, *z.bottom, z.br), (z.tl, *z.top, z.tr)


def _are_sound(offset: Offset, chords: Trapezoidation, points: Columns) -> Bools:
    """Return which trapezoids are sure to break no clause of the definition."""
    edges, corners = (_table([(z.left, z.right) for z in chords.trapezoids], 2),
                      _table([(z.bl, z.br, z.tl, z.tr) for z in chords.trapezoids], 4))
    bl, br, tl, tr = corners
    sides = [_sides(z) for z in chords.trapezoids]
    height = {level: offset.height(level) for z in chords.trapezoids for level in (z.low, z.high)}
    at = points.points
    sound: Bools = ((bl != br) | (tl != tr)) & np.fromiter((
        z.low < z.high and all(at[v].y == height[z.low] for v in bottom)
        and all(at[v].y == height[z.high] for v in top)
        for z, (bottom, top) in zip(chords.trapezoids, sides, strict=True)), np.bool_, len(sides))
    rows = Rows([row for both in sides for row in both])
    row = np.repeat(np.arange(len(rows)), rows.size)
    # Neighbours within rows; a side of two equal corners is an apex.
    u = np.delete(np.arange(len(rows.flat)), rows.start[1:] - 1)
    u = u[(rows.size[row[u]] > 2) | (rows.flat[u] != rows.flat[u + 1])]
    order = (points.x[rows.flat[u + 1]] - points.x[rows.flat[u]]).signs()
    for i in np.flatnonzero(order <= 0).tolist():
        if points[rows.flat[u[i]]].x >= points[rows.flat[u[i] + 1]].x:
            sound[row[u[i]] // 2] = False
    note("order on a side", len(u), int((order == 0).sum()))
    for leg, ends in zip(edges, ((bl, tl), (br, tr)), strict=True):
        for v in ends:
            sound &= _is_on_edge(offset, chords, points, leg, v)
    return sound


def _is_on_edge(offset: Offset, chords: Trapezoidation, points: Columns, edge: Ints, v: Ints) -> Bools:
    """Return whether vertices lie on the lines of edges of Q: those recorded there do, by the check of the chains."""
    following = indices(offset.successors())
    recorded = np.append(indices(chords.edge), -1)
    is_end = (v >= chords.first) & (v < chords.first + len(chords.edge))
    known: Bools = np.where(is_end, recorded[np.where(is_end, v - chords.first, -1)] == edge,
                     (v == offset.first + edge) | (v == offset.first + following[edge]))
    for i in np.flatnonzero(~known).tolist():
        a, b = points[offset.first + edge[i]], points[offset.first + following[edge[i]]]
        known[i] = orientation(a, b, points[v[i]]) == 0
    return known


def _chord_ends(chords: Trapezoidation) -> range:
    return range(chords.first, chords.first + len(chords.points))


def _cycle(z: Trapezoid) -> Cycle:
    """Return the boundary, counter-clockwise; an apex counts once."""
    top = (z.tr, *z.top[::-1], z.tl) if z.tr != z.tl else (z.tl,)
    return (z.bl, *z.bottom, z.br, *top) if z.bl != z.br else (z.bl, *top)


def _broken(z: Trapezoid, legs: Sequence[tuple[Point, Point]], points: Sequence[Point],
            height: Callable[[int], mpq]) -> str | None:
    """Return the clause of the definition of a trapezoid that z breaks; `legs` are the edges of its two legs."""
    if z.high <= z.low:
        return "a trapezoid has a height"
    for level, row in ((z.low, (z.bl, *z.bottom, z.br)), (z.high, (z.tl, *z.top, z.tr))):
        if any(points[v].y != height(level) for v in row):
            return "a side lies on its level"
        if any(points[u].x >= points[v].x for u, v in pairwise(row)) and not (len(row) == 2 and row[0] == row[1]):
            return "a side runs from left to right"
    if z.bl == z.br and z.tl == z.tr:
        return "a trapezoid has an inside"
    for (a, b), (low, high) in zip(legs, ((z.bl, z.tl), (z.br, z.tr)), strict=True):
        if orientation(a, b, points[low]) or orientation(a, b, points[high]):
            return "a leg lies on its edge of Q"
    return None
