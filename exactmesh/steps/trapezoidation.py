"""Cut the region inside Q into trapezoids by horizontal chords through its vertices (paper §2, P5).

In      `Offset`, a set of disjoint simple rings with the region on their left and all vertices on levels.
Out     `Trapezoidation`.
Exact   levels are integers; the abscissa of a chord end is a crossing of an edge with a level.
How     one sweep upwards over the levels that carry vertices. The edges crossed by the sweep line, from left to
        right, are left and right legs in turn; a trapezoid ends at a level where a vertex lies on the closed segment
        between its legs. Several vertices and horizontal edges on one level need no special treatment.
Check   `trapezoidation_check.py`
"""

from collections import defaultdict
from collections.abc import Sequence
from math import inf
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.columns import column_of
from exactmesh.geometry.decisions import note
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
        self.filter = _Filter(offset, self.lower, self.upper)
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
        note("place in the sweep", self.filter.asked, self.filter.exactly)
        return Trapezoidation(self._first, tuple(self.chord_ends), tuple(self.chord_edges), tuple(self.trapezoids))

    @property
    def _first(self) -> int:
        return self.offset.first + len(self.x)

    def _pass(self, level: int, row: list[int]) -> None:
        """Move the sweep line over one level, which carries the vertices `row` from left to right."""
        self.height = self.offset.points[row[0]].y
        places = [self.filter.place(self.status, v, level) for v in row]
        starting = [self.filter.from_the_left(self.starting[v]) for v in row]
        below, going_on = self._touched(row, places, starting, level)
        ends: dict[int, int] = {}
        for left, inner in below.items():
            self._close(left, level, inner, ends)
        self._replace(row, places, starting)
        above, begun = self._inner_above(row, places, starting)
        for left, place in (going_on | begun).items():
            self._open(left, self.status[place + 1], level, above.get(left, []), ends)

    def _touched(self, row: list[int], places: list[int], starting: Sequence[Sequence[int]], level: int
                 ) -> tuple[dict[int, list[int]], dict[int, int]]:
        """Return the left legs of the open trapezoids that a vertex of the row lies on, with the vertices strictly
        between the legs; and those of the legs that go on upwards, with their places in the status to be."""
        status, is_left = self.status, self.is_left
        touched: dict[int, list[int]] = {}
        going_on: dict[int, int] = {}
        moved = 0
        for v, at, edges in zip(row, places, starting, strict=True):
            ending = len(self.ending[v])
            for place in range(at, at + ending):
                left = status[place] if is_left[status[place]] else status[place - 1]
                touched.setdefault(left, [])
            if at and is_left[status[at - 1]]:
                left = status[at - 1]
                inner = touched.setdefault(left, [])
                if not ending:
                    inner.append(v)
                if left not in going_on and self.level[self.upper[left]] > level:
                    going_on[left] = at - 1 + moved
            moved += len(edges) - ending
        return touched, {left: going_on[left] for left in touched if left in going_on}

    def _replace(self, row: list[int], places: list[int], starting: Sequence[Sequence[int]]) -> None:
        """Put the edges that start at the vertices of the row in place of those that end there."""
        status = self.status
        if len(row) < _MANY:
            for v, at, edges in zip(reversed(row), reversed(places), reversed(starting), strict=True):
                status[at : at + len(self.ending[v])] = edges
            return
        merged: list[int] = []
        end = 0
        for v, at, edges in zip(row, places, starting, strict=True):
            merged += status[end:at]
            merged += edges
            end = at + len(self.ending[v])
        self.status = merged + status[end:]

    def _inner_above(self, row: list[int], places: list[int], starting: Sequence[Sequence[int]]
                     ) -> tuple[dict[int, list[int]], dict[int, int]]:
        """Return the vertices of the row strictly between two legs above, by the left leg; and the left legs that
        begin at the row, with their places in the status."""
        above: dict[int, list[int]] = defaultdict(list)
        begun: dict[int, int] = {}
        moved = 0
        for v, at, edges in zip(row, places, starting, strict=True):
            for e in self.starting[v]:
                if self.is_left[e]:
                    begun[e] = at + moved + edges.index(e)
            if not edges and at + moved and self.is_left[self.status[at + moved - 1]]:
                above[self.status[at + moved - 1]].append(v)
            moved += len(edges) - len(self.ending[v])
        return above, begun

    def _close(self, left: int, level: int, inner: list[int], ends: dict[int, int]) -> None:
        begun = self.open.pop(left)
        tl, tr = self._leg_at(left, level, ends), self._leg_at(begun.right, level, ends)
        self.trapezoids.append(Trapezoid(begun.low, level, left, begun.right, begun.bl, begun.br, tr, tl,
                                         begun.bottom, self._named(inner)))

    def _open(self, left: int, right: int, level: int, inner: list[int], ends: dict[int, int]) -> None:
        bl, br = self._leg_at(left, level, ends), self._leg_at(right, level, ends)
        self.open[left] = _Open(level, right, bl, br, self._named(inner))

    def _named(self, inner: list[int]) -> Cycle:
        return tuple([self.offset.first + v for v in inner])

    def _leg_at(self, e: int, level: int, ends: dict[int, int]) -> int:
        """Return the vertex at which edge e meets the level; a new chord end when e has no vertex there."""
        for v in (self.lower[e], self.upper[e]):
            if self.level[v] == level:
                return self.offset.first + v
        if e not in ends:
            ends[e] = self._first + len(self.chord_ends)
            self.chord_ends.append(Point(self.filter.x_at(e, level), self.height))
            self.chord_edges.append(e)
        return ends[e]


# Numbers of levels up to this are exact in floats.
_FEW = 1 << 50
# With so many vertices on a level the status is made anew rather than changed in so many places.
_MANY = 16


class _Filter:
    """Places of edges at levels: floats with an error bound, and exact numbers where they leave an order open.

    With R the greatest error of a rounded abscissa and M the greatest abscissa, a slope times a number of levels up to
    the edge's is off by at most 2 R + 2**-51 (2 M), a place by R + 2**-52 (2 M) more, and the difference of two of them
    by twice that and 2**-53 (4 M): less than `error` = 8 R + 2**-47 M.
    """

    def __init__(self, offset: Offset, lower: Sequence[int], upper: Sequence[int]) -> None:
        self.x, self.level = offset.x, offset.level
        self.lower, self.upper = lower, upper
        column = column_of(offset.x)
        xs = self.rounded = column.mid.tolist()
        self.error = float(8 * column.rad.max() + 2.0**-47 * abs(column.mid).max()) if xs else 0.0
        self.base = min(self.level, default=0)
        if max(self.level, default=0) - self.base >= _FEW:
            self.error = inf
        height = self.height = [self._height(level) for level in self.level]
        self.slope = [(xs[b] - xs[a]) / (height[b] - height[a]) if height[a] != height[b] else 0.0
                      for a, b in zip(lower, upper, strict=True)]
        self.asked = self.exactly = 0

    def _height(self, level: int) -> float:
        """Return the number of levels from the lowest one, exactly; where that is too much for floats, anything."""
        return float(level - self.base) if self.error < inf else 0.0

    def x_at(self, e: int, level: int) -> mpq:
        """Return the abscissa of edge e at a level."""
        a, b = self.lower[e], self.upper[e]
        x, low = self.x[a], self.level[a]
        return x + (self.x[b] - x) * (level - low) / (self.level[b] - low)

    def place(self, status: Sequence[int], v: int, level: int) -> int:
        """Return how many edges of the status are left of vertex v, which is on the level."""
        lower, upper, xs, heights, slope, error = (self.lower, self.upper, self.rounded, self.height, self.slope,
                                                   self.error)
        x, height = xs[v], self._height(level)
        start, end = 0, len(status)
        while start < end:
            middle = (start + end) >> 1
            e = status[middle]
            self.asked += 1
            a = lower[e]
            off = xs[a] + slope[e] * (height - heights[a]) - x
            if off < -error:
                start = middle + 1
            elif off > error or upper[e] == v or self._is_exactly(self.x_at(e, level) >= self.x[v]):
                end = middle
            else:
                start = middle + 1
        return start

    def from_the_left(self, edges: Sequence[int]) -> Sequence[int]:
        """Return edges that start at one vertex from left to right."""
        return edges if len(edges) < 2 else sorted(edges, key=self._exact_slope)

    def _exact_slope(self, e: int) -> mpq:
        a, b = self.lower[e], self.upper[e]
        return (self.x[b] - self.x[a]) / (self.level[b] - self.level[a])

    def _is_exactly(self, outcome: bool) -> bool:
        self.exactly += 1
        return bool(outcome)
