"""The paper's Lemma 3: a rectangle with vertices on one side, triangulated from one corner (Fig. 2 C and 3).

In      the occupied positions 0 = u_0 < u_1 < .. < u_m = c on the bottom side, as integers: multiples of the spacing w.
Out     `UnitPiece`: faces that refer to u_j by j, to the upper corners by m + 1 (left) and m + 2 (right), to new
        vertices by -1 - i; their places in units of w across and of the rectangle's height h upwards.
Exact   rational.
Paper   Anchored edges e_i run from the upper left corner A to E_i = (2^i, 1/3), the middle of a vertical edge g_i that
        stands on position 2^i and ends on e_i+1; teeth fill what is below. The text leaves open, and here is supplied:
        - the right end: the last E stands over the last occupied position L, at least 2 and less than 4 times as far
          as the one before it, and is joined to both right corners;
        - a position 2^i that is not occupied: g_i has no lower half; E_i stands over a gap and is joined to its ends;
        - teeth: over the middle of each gap ("midpoint", the only visible source of the w/2 in the text), or with the
          middles of g_i as the apexes of the gaps beside them ("retiled"), which the stated bound needs.
Check   `lemma_3_check.py`
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.records import Cycle, UnitPiece

Teeth = Literal["midpoint", "retiled"]
_LOW = mpq(1, 3)


def triangulate_rectangle(positions: Sequence[int], teeth: Teeth = "midpoint") -> UnitPiece:
    """Return the nonproper triangulation of Lemma 3; at least one inner position must be occupied."""
    if len(positions) < 3 or positions[0] != 0 or any(u >= v for u, v in pairwise(positions)):
        raise ValueError(f"positions must increase from 0 and have one inside, not {list(positions)}")
    return _Figure(tuple(positions), teeth).run()


@dataclass(slots=True)
class _Node:
    """E_i: `index` is its new vertex, `left` the last position at or before it; it has a foot when that is its own.

    `on_edge` lists the vertices on e_i from A on, E_i last.
    """

    x: int
    index: int
    left: int
    has_foot: bool
    on_edge: list[int]


class _Figure:
    """The figure as it grows."""

    def __init__(self, positions: tuple[int, ...], teeth: Teeth) -> None:
        self.u = positions
        self.teeth = teeth
        self.a, self.c = len(positions), len(positions) + 1
        self.faces: list[Cycle] = []
        self.new: list[Point] = []
        self.nodes = [self._node(x) for x in self._abscissae()]

    def run(self) -> UnitPiece:
        first, last, m = self.nodes[0], self.nodes[-1], len(self.u) - 1
        self._fill_gaps_below_nodes()
        if first.has_foot:
            self._face(0, first.left, first.index)
        self._face(0, first.index, self.a)
        for node, following in pairwise(self.nodes):
            self._between(node, following)
        self._face(self.a, *last.on_edge, self.c)
        self._face(m - 1, m, last.index)
        self._face(m, self.c, last.index)
        return UnitPiece(tuple(self.faces), tuple(self.new))

    def _abscissae(self) -> list[int]:
        last = self.u[-2]
        found = []
        x = 1
        while 2 * x <= last:
            found.append(x)
            x *= 2
        return [*found, last]

    def _node(self, x: int) -> _Node:
        left = bisect_right(self.u, x) - 1
        index = self._add(mpq(x), _LOW)
        return _Node(x, index, left, self.u[left] == x, [index])

    def _add(self, x: mpq, y: mpq) -> int:
        self.new.append(Point(x, y))
        return -len(self.new)

    def _face(self, *cycle: int) -> None:
        self.faces.append(cycle)

    def _fill_gaps_below_nodes(self) -> None:
        """Triangulate, below the nodes without a foot, each gap that has some: a fan from its left end."""
        for j in range(len(self.u) - 1):
            above = [node.index for node in self.nodes if not node.has_foot and node.left == j]
            if above:
                self._face(j, j + 1, above[-1])
                for e, f in pairwise(above):
                    self._face(j, f, e)

    def _between(self, node: _Node, following: _Node) -> None:
        """Fill the region below e_i+1 from g_i to g_i+1, and the triangle A E_i top_i above e_i."""
        top = self._on(following, mpq(node.x))
        self._face(self.a, *node.on_edge, top)
        if node.left == following.left and not node.has_foot:
            # Both stand over one gap, whose fan has the edge between them.
            self._face(node.index, following.index, top)
            following.on_edge.insert(0, top)
            return
        start = node.left if node.has_foot else node.left + 1
        end = following.left
        own_start, own_end = node.has_foot, following.has_foot
        apexes: dict[int, int] = {}
        if self.teeth == "retiled" and own_start and end > start:
            self._face(start, start + 1, node.index)
            start, own_start = start + 1, False
        elif self.teeth == "retiled" and end == start:
            own_start = False
        if self.teeth == "retiled" and own_end and end > start:
            apexes[end - 1] = following.index
        for j in range(start, end):
            if j not in apexes:
                apexes[j] = self._on(following, mpq(self.u[j] + self.u[j + 1], 2))
        self._stitch(node, following, top, start, end, own_start, [apexes[j] for j in range(start, end)])

    def _stitch(self, node: _Node, following: _Node, top: int, start: int, end: int, on_foot: bool,
                apexes: list[int]) -> None:
        """Add the teeth from position `start` to `end` and the triangles that join them to g_i and to E_i+1.

        `on_foot` tells that position `start` is the foot of g_i and sees all of g_i.
        """
        first = apexes[0] if apexes else following.index
        if on_foot:
            self._face(start, first, top, node.index)
        elif apexes:
            self._face(start, first, top)
            self._face(start, top, node.index)
        else:
            self._face(node.index, start, following.index)
            self._face(node.index, following.index, top)
        for j, apex in enumerate(apexes, start):
            self._face(j, j + 1, apex)
        for j, (apex, after) in enumerate(pairwise(apexes), start + 1):
            self._face(apex, j, after)
        if apexes and apexes[-1] != following.index:
            self._face(apexes[-1], end, following.index)
        new = [v for v in (top, *apexes) if v != following.index]
        following.on_edge[:0] = new

    def _on(self, node: _Node, x: mpq) -> int:
        """Return a new vertex on the edge from A to a node."""
        return self._add(x, 1 + x / node.x * (_LOW - 1))
