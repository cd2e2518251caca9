"""For checkers: the edges of Q cut at the vertices recorded on them, each record checked against its place."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point, minus
from exactmesh.geometry.predicates import is_between, orientation
from exactmesh.planar.cycles import Side
from exactmesh.steps.records import Offset


@dataclass(frozen=True, slots=True)
class Misplaced:
    """A recorded vertex that does not lie in the interior of its edge."""

    edge_of_q: int
    vertex: int


def edge_chains(offset: Offset, on_edge: Iterable[tuple[int, int]], points: Sequence[Point]
                ) -> list[list[int]] | Misplaced:
    """Return, for each edge k of Q, its vertices in order along it, from vertex k to the next one of the ring."""
    following = offset.successors()
    chains = [[offset.first + k] for k in range(len(following))]
    for k, v in on_edge:
        a, b, p = points[offset.first + k], points[offset.first + following[k]], points[v]
        if orientation(a, b, p) != 0 or not is_between(a, p, b) or p in (a, b):
            return Misplaced(k, v)
        chains[k].append(v)
    for k, chain in enumerate(chains):
        steps = [(_length(minus(points[v], points[chain[0]])), v) for v in chain]
        chain[:] = [v for _, v in sorted(steps)] + [offset.first + following[k]]
    return chains


def chain_sides(chains: Iterable[Sequence[int]]) -> set[Side]:
    """Return the directed edges of all chains."""
    return {side for chain in chains for side in pairwise(chain)}


def _length(step: Point) -> mpq:
    """Return a measure that grows along a line."""
    return abs(step.x) + abs(step.y)
