"""Check the trapezoidation from what it has to be; `trapezoidation.py` is not imported.

Tiling   each trapezoid is a quadrilateral (or triangle) between two levels with its legs on edges of Q, its sides list
         all vertices on them, and the boundaries of all trapezoids add up to Q: so they tile the inside of Q, and no
         vertex lies inside one.
I4       two vertices of Q on one horizontal side, one of them a T-vertex, are 0.15 apart or more; a T-vertex keeps
         0.0599 from both legs.
I5       each horizontal side holds a vertex of Q.
I5'      a corner that is no vertex of Q is on an edge of Q that goes on for at least one level beyond it.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges
from exactmesh.steps.constants import GAP, LEVEL, SEPARATION
from exactmesh.steps.edge_chains import Misplaced, chain_sides, edge_chains
from exactmesh.steps.records import Cycle, Offset, Trapezoid, Trapezoidation


def check_tiling(offset: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return whether the trapezoids tile the inside of Q; one instance a trapezoid."""
    chains = edge_chains(offset, zip(chords.edge, _chord_ends(chords), strict=True), points)
    if isinstance(chains, Misplaced):
        return failed(0, "a chord end lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)
    count = len(chords.trapezoids)
    following = offset.successors()
    for number, z in enumerate(chords.trapezoids):
        legs = [(offset.points[e], offset.points[following[e]]) for e in (z.left, z.right)]
        if (clause := _broken(z, legs, points, offset.height)) is not None:
            return failed(number + 1, clause, trapezoid=number, at=str(points[z.bl]))
    owner, repeated = directed_edges(_cycle(z) for z in chords.trapezoids)
    if repeated:
        return failed(count, "trapezoids do not overlap", trapezoid=repeated[0][1], edge=list(repeated[0][0]))
    outside = {side for side in owner if side[::-1] not in owner}
    if odd := outside ^ chain_sides(chains):
        return failed(count, "the trapezoids' boundaries add up to Q", edge=list(min(odd)))
    return Verdict(count, True)


def check_gaps(offset: Offset, chords: Trapezoidation, points: Sequence[Point]) -> tuple[Verdict, Verdict]:
    """Return the verdicts on the least squared gap along a side and the least squared distance to a leg (I4)."""
    gaps = Tally("gap to a T-vertex >= 0.15", ">=", GAP**2)
    legs = Tally("T-vertex to leg >= 0.0599", ">=", SEPARATION**2)
    of_q = range(offset.first, chords.first)
    for number, z in enumerate(chords.trapezoids):
        for left, inner, right in ((z.bl, z.bottom, z.br), (z.tl, z.top, z.tr)):
            row = [left, *inner, right] if inner else []
            for u, v in pairwise(row):
                if u in of_q and v in of_q:
                    gaps.see((points[v].x - points[u].x) ** 2, trapezoid=number, vertices=[u, v], at=str(points[u]))
            for v in inner:
                for a, b in ((z.bl, z.tl), (z.br, z.tr)):
                    squared = segment_distance_squared(points[v], points[a], points[b])
                    legs.see(squared, trapezoid=number, vertex=v, at=str(points[v]))
    return gaps.verdict(), legs.verdict()


def check_touch(offset: Offset, chords: Trapezoidation) -> Verdict:
    """Return whether each horizontal side holds a vertex of Q (I5); the worst is the least number of them."""
    tally = Tally("vertices of Q on a side >= 1", ">=", mpq(1))
    of_q = range(offset.first, chords.first)
    for number, z in enumerate(chords.trapezoids):
        for side in ((z.bl, *z.bottom, z.br), (z.tl, *z.top, z.tr)):
            tally.see(mpq(sum(v in of_q for v in side)), trapezoid=number)
    return tally.verdict()


def check_clearance(offset: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on how far, vertically, edges of Q go on beyond chord ends (I5'); one instance an end."""
    tally = Tally("the edge goes on for g or more", ">=", LEVEL)
    following = offset.successors()
    for v, edge in zip(_chord_ends(chords), chords.edge, strict=True):
        for end in (edge, following[edge]):
            tally.see(abs(offset.points[end].y - points[v].y), vertex=v, edge_of_q=edge, at=str(points[v]))
    return tally.verdict()


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
