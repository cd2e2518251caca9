"""Half-edges: topology over indices, without coordinates.

Edge e = (u, v) has the half-edges 2e from u to v and 2e + 1 from v to u, so twin(h) = h ^ 1 and the edge is h >> 1.
The face of a half-edge lies on its left; `next` goes on along that face.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from exactmesh.planar.pslg import Edge


@dataclass(frozen=True, slots=True)
class HalfEdges:
    """`origin[h]` is a vertex, `next[h]` the half-edge after h on the same boundary walk."""

    origin: tuple[int, ...]
    next: tuple[int, ...]

    def target(self, h: int) -> int:
        """Return the vertex that h leads to."""
        return self.origin[h ^ 1]


def outgoing(edges: Sequence[Edge], vertex_count: int) -> list[list[int]]:
    """Return, for each vertex, the half-edges that leave it, by index."""
    leaving: list[list[int]] = [[] for _ in range(vertex_count)]
    for e, (u, v) in enumerate(edges):
        leaving[u].append(2 * e)
        leaving[v].append(2 * e + 1)
    return leaving


def link(edges: Sequence[Edge], rotation: Sequence[Sequence[int]]) -> HalfEdges:
    """Return the half-edges of an embedding; `rotation[v]` lists those leaving v counter-clockwise."""
    origin = tuple(end for edge in edges for end in edge)
    successor = [0] * len(origin)
    for leaving in rotation:
        for i, h in enumerate(leaving):
            # Arriving along twin(h), the face on the left goes on along the half-edge next clockwise from h.
            successor[h ^ 1] = leaving[i - 1]
    return HalfEdges(origin, tuple(successor))


def walks(half_edges: HalfEdges) -> list[tuple[int, ...]]:
    """Return the boundary walks: the cycles of `next`, each from its least half-edge."""
    seen = bytearray(len(half_edges.origin))
    found = []
    for start in range(len(seen)):
        if seen[start]:
            continue
        walk = []
        h = start
        while not seen[h]:
            seen[h] = 1
            walk.append(h)
            h = half_edges.next[h]
        found.append(tuple(walk))
    return found
