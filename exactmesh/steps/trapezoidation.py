"""Cut the region inside Q into trapezoids by horizontal chords through its vertices (paper §2, P5).

In      `Offset`, a set of disjoint simple rings with the region on their left and all vertices on levels.
Out     `Trapezoidation`.
Exact   levels are integers; the abscissa of a chord end is a crossing of an edge with a level.
How     one sweep upwards over the levels that carry vertices. The edges crossed by the sweep line, from left to
        right, are left and right legs in turn; a trapezoid ends at a level where a vertex lies on the closed segment
        between its legs. Several vertices and horizontal edges on one level need no special treatment.
Check   `trapezoidation_check.py`
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.records import Cycle, Offset, Trapezoid, Trapezoidation


class _Open(NamedTuple):
    """A trapezoid that goes on upwards."""

    low: int
    right: int
    bl: int
    br: int
    bottom: Cycle


def trapezoidate(offset: Offset) -> Trapezoidation:
    """Return the horizontal trapezoidation of the region inside the rings of `offset`."""
    return _Sweep(offset).run()


class _Sweep:
    """`status` lists the edges that reach above the sweep line, from left to right; an edge has the number of the
    vertex of Q it starts from. `lower[e]`, `upper[e]` are its ends by level, as vertices of Q."""

    def __init__(self, offset: Offset) -> None:
        self.offset = offset
        self.x, self.level = offset.x, offset.level
        self.lower, self.upper = list(range(len(self.x))), offset.successors()
        self.is_left = [False] * len(self.x)
        self.starting: dict[int, list[int]] = defaultdict(list)
        self.ending: dict[int, list[int]] = defaultdict(list)
        for e, (a, b) in enumerate(zip(self.lower, self.upper, strict=True)):
            if self.level[a] == self.level[b]:
                continue
            if self.level[a] > self.level[b]:
                # The region is on the left of Q, so an edge that runs down has it on its east: it is a left leg.
                self.is_left[e] = True
                self.lower[e], self.upper[e] = b, a
            self.starting[self.lower[e]].append(e)
            self.ending[self.upper[e]].append(e)
        self.status: list[int] = []
        self.open: dict[int, _Open] = {}
        self.trapezoids: list[Trapezoid] = []
        self.chord_ends: list[Point] = []
        self.chord_edges: list[int] = []

    def run(self) -> Trapezoidation:
        rows: dict[int, list[int]] = defaultdict(list)
        for v, level in enumerate(self.level):
            rows[level].append(v)
        for level in sorted(rows):
            self._pass(level, sorted(rows[level], key=self.x.__getitem__))
        return Trapezoidation(self._first, tuple(self.chord_ends), tuple(self.chord_edges), tuple(self.trapezoids))

    @property
    def _first(self) -> int:
        return self.offset.first + len(self.x)

    def _pass(self, level: int, row: list[int]) -> None:
        """Move the sweep line over one level, which carries the vertices `row` from left to right."""
        xs = [self.x[v] for v in row]
        touched = self._touched(level, row)
        ends: dict[int, int] = {}
        for left in touched:
            self._close(left, level, row, xs, ends)
        for v in row:
            at = bisect_left(self.status, self.x[v], key=lambda e: self._x_at(e, level))
            self.status[at : at + len(self.ending[v])] = sorted(self.starting[v], key=self._slope)
        going_on = [e for e in touched if self.level[self.upper[e]] > level]
        begun = [e for v in row for e in self.starting[v] if self.is_left[e]]
        for left in going_on + begun:
            self._open(left, level, row, xs, ends)

    def _touched(self, level: int, row: list[int]) -> list[int]:
        """Return the left legs of the open trapezoids that a vertex of the row lies on, each once."""
        touched: dict[int, None] = {}
        for v in row:
            at = bisect_left(self.status, self.x[v], key=lambda e: self._x_at(e, level))
            if self.ending[v]:
                for e in self.status[at : at + len(self.ending[v])]:
                    left = e if self.is_left[e] else self.status[self._index(e, level) - 1]
                    touched[left] = None
            elif at and self.is_left[self.status[at - 1]]:
                touched[self.status[at - 1]] = None
        return list(touched)

    def _close(self, left: int, level: int, row: list[int], xs: list[mpq], ends: dict[int, int]) -> None:
        begun = self.open.pop(left)
        tl, tr = self._leg_at(left, level, ends), self._leg_at(begun.right, level, ends)
        self.trapezoids.append(Trapezoid(begun.low, level, left, begun.right, begun.bl, begun.br, tr, tl,
                                         begun.bottom, self._between(left, begun.right, level, row, xs)))

    def _open(self, left: int, level: int, row: list[int], xs: list[mpq], ends: dict[int, int]) -> None:
        right = self.status[self._index(left, level) + 1]
        bl, br = self._leg_at(left, level, ends), self._leg_at(right, level, ends)
        self.open[left] = _Open(level, right, bl, br, self._between(left, right, level, row, xs))

    def _between(self, left: int, right: int, level: int, row: list[int], xs: list[mpq]) -> Cycle:
        """Return the vertices of the row strictly between two legs."""
        start = bisect_right(xs, self._x_at(left, level))
        end = bisect_left(xs, self._x_at(right, level))
        return tuple(self.offset.first + v for v in row[start:end])

    def _leg_at(self, e: int, level: int, ends: dict[int, int]) -> int:
        """Return the vertex at which edge e meets the level; a new chord end when e has no vertex there."""
        for v in (self.lower[e], self.upper[e]):
            if self.level[v] == level:
                return self.offset.first + v
        if e not in ends:
            ends[e] = self._first + len(self.chord_ends)
            self.chord_ends.append(Point(self._x_at(e, level), self.offset.height(level)))
            self.chord_edges.append(e)
        return ends[e]

    def _index(self, e: int, level: int) -> int:
        """Return the place of edge e in the status; edges that start from one vertex share their abscissa."""
        at = bisect_left(self.status, self._x_at(e, level), key=lambda f: self._x_at(f, level))
        while self.status[at] != e:
            at += 1
        return at

    def _x_at(self, e: int, level: int) -> mpq:
        a, b = self.lower[e], self.upper[e]
        x, low = self.x[a], self.level[a]
        return x + (self.x[b] - x) * (level - low) / (self.level[b] - low)

    def _slope(self, e: int) -> mpq:
        a, b = self.lower[e], self.upper[e]
        return (self.x[b] - self.x[a]) / (self.level[b] - self.level[a])
