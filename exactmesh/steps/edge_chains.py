"""For checkers: the edges of Q cut at the vertices recorded on them, each record checked against its place."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from exactmesh.geometry.balls import Ints
from exactmesh.geometry.columns import Columns, Rows
from exactmesh.geometry.point import Point
from exactmesh.steps.records import Offset

Chains = list[list[int]]


@dataclass(frozen=True, slots=True)
class Misplaced:
    """A recorded vertex that does not lie in the interior of its edge."""

    edge_of_q: int
    vertex: int


def edge_chains(offset: Offset, on_edge: Iterable[tuple[int, int]], points: Sequence[Point]) -> Chains | Misplaced:
    """Return, for each edge k of Q, its vertices in order along it, from vertex k to the next one of the ring."""
    first = offset.first
    points = points.points if isinstance(points, Columns) else points
    following = offset.successors()
    inner: dict[int, list[int]] = {}
    for k, v in on_edge:
        a, b, p = points[first + k], points[first + following[k]], points[v]
        (ax, ay), (bx, by), (x, y) = a, b, p
        # On a line, points are in lexicographic order. Heights are few, so that these rationals stay short.
        if not (a < p < b or b < p < a) or (bx - ax) * (y - ay) != (by - ay) * (x - ax):
            return Misplaced(k, v)
        inner.setdefault(k, []).append(v)
    chains = [[first + k, first + end] for k, end in enumerate(following)]
    for k, between in inner.items():
        if len(between) > 1:
            between.sort()
            between.sort(key=points.__getitem__, reverse=points[first + following[k]] < points[first + k])
        chains[k][1:1] = between
    return chains


def chain_sides(chains: Sequence[Sequence[int]]) -> Ints:
    """Return the directed edges of all chains as pairs of vertices; a chain is not empty."""
    rows = Rows(chains)
    sides: Ints = np.column_stack((np.delete(rows.flat, rows.start[1:] - 1), np.delete(rows.flat, rows.start[:-1])))
    return sides
