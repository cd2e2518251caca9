"""Cut the region inside Q into trapezoids by horizontal chords through its vertices (paper §2, P5).

In      `Offset`, a set of disjoint simple rings with the region on their left and all vertices on levels.
Out     `Trapezoidation`.
Exact   levels are integers; the abscissa of a chord end is a crossing of an edge with a level.
How     one sweep upwards over the levels that carry vertices. The edges crossed by the sweep line, from left to
        right, are left and right legs in turn; a trapezoid ends at a level where a vertex lies on the closed segment
        between its legs. Several vertices and horizontal edges on one level need no special treatment. A vertex alone
        on its level where one edge ends and one starts, like most, replaces one leg by another and needs no search.
Check   `trapezoidation_check.py`
"""

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise
from math import inf
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.columns import column_of
from exactmesh.geometry.decisions import note
from exactmesh.geometry.point import Point
from exactmesh.planar.status import Status
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
    """An edge has the number of the vertex of Q it starts from. `lower[e]`, `upper[e]` are its ends by level, as
    vertices of Q; -1 when it is horizontal.

    Edges that reach above the sweep line are in strands: where one edge ends and one starts, a strand goes on with the
    next edge. `status` has the strands from left to right, `edge_of[strand]` their edges now. `open` has what is open
    by the strand of its left leg, `left_of` that strand by the one of the right leg.
    """

    def __init__(self, offset: Offset) -> None:
        self.offset = offset
        self.x, self.level = offset.x, offset.level
        self.lower, self.upper = list(range(len(self.x))), offset.successors()
        self.is_left = [False] * len(self.x)
        self.incoming = [0] * len(self.x)
        for e, (a, b) in enumerate(zip(self.lower, self.upper, strict=True)):
            self.incoming[b] = e
            if self.level[a] == self.level[b]:
                self.lower[e] = self.upper[e] = -1
            elif self.level[a] > self.level[b]:
                # The region is on the left of Q, so an edge that runs down has it on its east: it is a left leg.
                self.is_left[e] = True
                self.lower[e], self.upper[e] = b, a
        self.filter = _Filter(offset, self.lower, self.upper)
        self.status = Status(len(self.x))
        self.strand = list(range(len(self.x)))
        # The last one is for no strand, -1.
        self.edge_of = [*range(len(self.x)), -1]
        self.open: dict[int, _Open] = {}
        self.left_of: dict[int, int] = {}
        self._first = offset.first + len(self.x)
        self.trapezoids: list[Trapezoid] = []
        self.chord_ends: list[Point] = []
        self.chord_edges: list[int] = []

    def run(self) -> Trapezoidation:
        rows: dict[int, list[int]] = defaultdict(list)
        for v, level in enumerate(self.level):
            rows[level].append(v)
        for level in sorted(rows):
            row = rows[level]
            self.height = self.offset.points[row[0]].y
            if len(row) > 1 or not self._replaced_a_leg(row[0], level):
                self._pass(level, sorted(row, key=self.x.__getitem__))
        note("place in the sweep", self.filter.asked, self.filter.exactly)
        return Trapezoidation(self._first, tuple(self.chord_ends), tuple(self.chord_edges), tuple(self.trapezoids))
    def _replaced_a_leg(self, v: int, level: int) -> bool:
        """Move the sweep line over a level with one vertex, if one edge ends there and one starts; return whether."""
        ended, begun = self.incoming[v], v
        if self.upper[begun] == v:
            ended, begun = begun, ended
        if self.upper[ended] != v or self.lower[begun] != v:
            return False
        strand = self.strand[begun] = self.strand[ended]
        self.edge_of[strand] = begun
        here, other = self.offset.first + v, self._first + len(self.chord_ends)
        if self.is_left[ended]:
            low, right, bl, br, bottom = self.open[strand]
            self.trapezoids.append(Trapezoid(low, level, ended, right, bl, br, other, here, bottom, ()))
            self.open[strand] = _Open(level, right, here, other, ())
            self._add_chord_end(right, level)
        else:
            strand = self.left_of[strand]
            left = self.edge_of[strand]
            low, _, bl, br, bottom = self.open[strand]
            self.trapezoids.append(Trapezoid(low, level, left, ended, bl, br, here, other, bottom, ()))
            self.open[strand] = _Open(level, begun, other, here, ())
            self._add_chord_end(left, level)
        return True

    def _pass(self, level: int, row: list[int]) -> None:
        """Move the sweep line over one level, which carries the vertices `row` from left to right."""
        found = [self._found(v, level) for v in row]
        below, going_on = self._touched(found, level)
        ends: dict[int, int] = {}
        for left, inner in below.items():
            self._close(left, level, inner, ends)
        beside = _beside(found)
        above: dict[int, list[int]] = defaultdict(list)
        begun: dict[int, int] = {}
        for here, (before, after) in zip(found, beside, strict=True):
            self._go_on(here, before)
            for e in sorted(here.starting):
                if self.is_left[e]:
                    begun[e] = after if e == here.starting[-1] else here.starting[1]
            if not here.starting and before >= 0 and self.is_left[before]:
                above[before].append(here.v)
        for left, number in going_on.items():
            self._open(left, (*found[number].starting, beside[number][1])[0], level, above.get(left, []), ends)
        for left, right in begun.items():
            self._open(left, right, level, above.get(left, []), ends)

    def _found(self, v: int, level: int) -> "_Found":
        """Return what the sweep line meets at a vertex."""
        status, edge_of = self.status, self.edge_of
        edges = self.incoming[v], v
        ending = [e for e in edges if self.upper[e] == v]
        starting = [e for e in edges if self.lower[e] == v]
        if ending:
            at = status.place(self.strand[ending[0]])
            if len(ending) == 2 and status.before(at) == self.strand[ending[1]]:
                ending = ending[::-1]
                at = status.place(self.strand[ending[0]])
        else:
            at = status.first(lambda strands: self.filter.count_left(strands, edge_of, v, level))
        _, after = status.run(at, lambda strand: edge_of[strand] in ending)
        return _Found(v, edge_of[status.before(at)], ending, edge_of[after], self.filter.from_the_left(starting))

    def _go_on(self, here: "_Found", before: int) -> None:
        """Put the edges that start at a vertex in the place of those that end there, right of the edge `before`."""
        status, strand = self.status, self.strand
        if len(here.ending) == len(here.starting) == 1:
            strand[here.starting[0]] = strand[here.ending[0]]
            self.edge_of[strand[here.ending[0]]] = here.starting[0]
        elif here.ending:
            status.replace(status.place(strand[here.ending[0]]), len(here.ending), here.starting)
        elif here.starting:
            at = status.first(lambda strands: 0)
            if before >= 0:
                block, place = status.place(strand[before])
                at = block, place + 1
            status.replace(at, 0, here.starting)

    def _touched(self, found: "list[_Found]", level: int) -> tuple[dict[int, list[int]], dict[int, int]]:
        """Return the left legs of the open trapezoids that a vertex of the row lies on, with the vertices strictly
        between the legs; and those of the legs that go on upwards, with the place in the row of the first vertex."""
        touched: dict[int, list[int]] = {}
        first: dict[int, int] = {}
        for number, here in enumerate(found):
            last = here.before
            for e in here.ending:
                touched.setdefault(e if self.is_left[e] else last, [])
                last = e
            if here.before >= 0 and self.is_left[here.before]:
                inner = touched.setdefault(here.before, [])
                if not here.ending:
                    inner.append(here.v)
                first.setdefault(here.before, number)
        return touched, {left: first[left] for left in touched if self.level[self.upper[left]] > level}

    def _close(self, left: int, level: int, inner: list[int], ends: dict[int, int]) -> None:
        begun = self.open.pop(self.strand[left])
        tl, tr = self._leg_at(left, level, ends), self._leg_at(begun.right, level, ends)
        self.trapezoids.append(Trapezoid(begun.low, level, left, begun.right, begun.bl, begun.br, tr, tl,
                                         begun.bottom, self._named(inner)))

    def _open(self, left: int, right: int, level: int, inner: list[int], ends: dict[int, int]) -> None:
        bl, br = self._leg_at(left, level, ends), self._leg_at(right, level, ends)
        self.open[self.strand[left]] = _Open(level, right, bl, br, self._named(inner))
        self.left_of[self.strand[right]] = self.strand[left]

    def _named(self, inner: list[int]) -> Cycle:
        return tuple([self.offset.first + v for v in inner])

    def _leg_at(self, e: int, level: int, ends: dict[int, int]) -> int:
        """Return the vertex at which edge e meets the level; a new chord end when e has no vertex there."""
        for v in (self.lower[e], self.upper[e]):
            if self.level[v] == level:
                return self.offset.first + v
        if e not in ends:
            ends[e] = self._first + len(self.chord_ends)
            self._add_chord_end(e, level)
        return ends[e]

    def _add_chord_end(self, e: int, level: int) -> None:
        self.chord_ends.append(Point(self.filter.x_at(e, level), self.height))
        self.chord_edges.append(e)


class _Found(NamedTuple):
    """What the sweep line meets at vertex v: the edges that end and start there from left to right, and the edges
    beside those, -1 where there is none."""

    v: int
    before: int
    ending: Sequence[int]
    after: int
    starting: Sequence[int]


def _beside(found: Sequence[_Found]) -> list[tuple[int, int]]:
    """Return the edges beside each vertex of a row, and beside the edges that start there, above the row."""
    before = [here.before for here in found]
    after = [here.after for here in found]
    # Two vertices with no edge between them below the row see what starts at the other.
    close = [u.ending[-1] == v.before if u.ending else u.before == v.before for u, v in pairwise(found)]
    for i, are_close in enumerate(close):
        if are_close:
            before[i + 1] = found[i].starting[-1] if found[i].starting else before[i]
    for i in range(len(close) - 1, -1, -1):
        if close[i]:
            after[i] = found[i + 1].starting[0] if found[i + 1].starting else after[i + 1]
    return list(zip(before, after, strict=True))


# Numbers of levels up to this are exact in floats.
_FEW = 1 << 50


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

    def count_left(self, strands: Sequence[int], edge_of: Sequence[int], v: int, level: int) -> int:
        """Return how many of some strands from left to right are left of vertex v, which is on the level; `edge_of` has
        the edges that they are now."""
        lower, upper, xs, heights, slope, error = (self.lower, self.upper, self.rounded, self.height, self.slope,
                                                   self.error)
        x, height = xs[v], self._height(level)
        start, end = 0, len(strands)
        while start < end:
            middle = (start + end) >> 1
            e = edge_of[strands[middle]]
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
