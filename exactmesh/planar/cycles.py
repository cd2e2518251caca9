"""Boundaries of sets of cycles, by index alone."""

from collections.abc import Iterable
from itertools import pairwise

Cycle = tuple[int, ...]
Side = tuple[int, int]


def sides(cycle: Cycle) -> Iterable[Side]:
    """Return the directed edges of a cycle, the closing one last; none of the empty cycle."""
    return (*pairwise(cycle), (cycle[-1], cycle[0])) if cycle else ()


def directed_edges(cycles: Iterable[Cycle]) -> tuple[dict[Side, int], list[tuple[Side, int]]]:
    """Return each directed edge with the number of the first cycle that has it, and the repeated ones with theirs."""
    owner: dict[Side, int] = {}
    repeated: list[tuple[Side, int]] = []
    for number, cycle in enumerate(cycles):
        repeated += [(side, number) for side in sides(cycle) if owner.setdefault(side, number) != number]
    return owner, repeated
