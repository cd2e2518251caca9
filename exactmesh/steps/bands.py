"""Triangulate the polygons that merged trapezoids make: bands between two chains that run from left to right.

In      the polygon as a counter-clockwise cycle of vertex numbers, the feature size wanted.
Out     `Band`: faces, new vertices, feet on edges of Q, the least squared feature size, and the sides that hem it in.
Exact   every candidate is measured exactly, and is a triangulation when its measure is positive: triangles that all
        turn left, and whose sides add up to the boundary, tile it.

Where a chain turns back, or rises steeply, ears are cut off. Edges between consecutive opposite vertices leave bands
with a chain on one side and one edge, the clean one, on the other. Such a band gets the best triangulation without new
vertices when it is small, nested triangles over the chain (`nested.py`, whose T-side may be crooked), or feet on
the clean edge, when that lies on Q. All that is tried in several ways, and the first that is good enough is taken.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.frame import Frame
from exactmesh.steps.heights import height_squared
from exactmesh.steps.nested import nested_trials
from exactmesh.steps.quad import quad
from exactmesh.steps.records import Cycle
from exactmesh.steps.wedges import BOTTOM, TOP

# So many vertices at most are triangulated without new ones by trying all ways.
_SMALL = 14
# What counts as steep: steps of a chain to another level that are shorter than so many times two levels.
_REACHES = (mpq(1, 4), mpq(1, 2), mpq(1), mpq(2), mpq(0))
# The chains from which ears are cut off that are longer than `_LONG_EAR` levels.
_LONG_EARS: tuple[tuple[int, ...], ...] = ((), (BOTTOM,), (TOP,), (BOTTOM, TOP))
_LONG_EAR = 8
# Heights from which nested triangles are laid out: the nearest levels of the chain.
_BASES = 3


class Ground:
    """Where bands lie: the places of vertices, the edges of Q each vertex is on, the level spacing, what is wanted."""

    def __init__(self, points: Sequence[Point], edges_at: dict[int, set[int]], level: mpq, wanted_squared: mpq) -> None:
        self.points, self.edges_at = points, edges_at
        self.level, self.wanted_squared = level, wanted_squared
        # The best found for bands with one chain: different ways to cut a polygon have many in common.
        self.parts: dict[tuple[object, ...], _Part] = {}

    def edge_of(self, u: int, v: int) -> int | None:
        """Return the edge of Q that two neighbours lie on, if there is one."""
        return min(self.edges_at.get(u, set()) & self.edges_at.get(v, set()), default=None)


class Band(NamedTuple):
    """A triangulation of one polygon: `new` are its new vertices, numbered on from the places of the ground; `feet` has
    pairs (edge of Q, vertex). `narrow` are sides of the polygon beside parts that keep less than what is wanted."""

    value: mpq
    faces: tuple[Cycle, ...]
    new: tuple[Point, ...]
    feet: tuple[tuple[int, int], ...]
    narrow: tuple[tuple[int, int], ...]


def triangulate_band(ground: Ground, cycle: Sequence[int]) -> Band | None:
    """Return the first triangulation that keeps what is wanted, else the best one; None when there is none."""
    best: Band | None = None
    tried: set[tuple[object, ...]] = set()
    for reach in _REACHES:
        for long_ears in _LONG_EARS:
            band = _Attempt(ground, cycle, 2 * reach * ground.level, long_ears).band(tried)
            if band is not None and (best is None or band.value > best.value):
                best = band
                if best.value >= ground.wanted_squared:
                    return best
    return best


class _Part(NamedTuple):
    """A triangulation of a part; in `faces` a number -1 - i stands for `new[i]`, in `feet` as well."""

    value: mpq
    faces: Sequence[Cycle]
    new: Sequence[Point] = ()
    feet: Sequence[tuple[int, int]] = ()


class _Attempt:
    """One way to cut a polygon: `reach` says what is steep, `long_ears` which chains may lose long ears."""

    def __init__(self, ground: Ground, cycle: Sequence[int], reach: mpq, long_ears: tuple[int, ...]) -> None:
        self.ground, self.reach, self.long_ears = ground, reach, long_ears
        self.wanted = ground.wanted_squared
        # What is steep at the end of a chain, and how far from its ends feet may stand on a clean edge.
        self.steep = max(reach, ground.level)
        self.cycle = list(cycle)
        self.at = {v: ground.points[v] for v in cycle}
        self.faces: list[Cycle] = []
        self.new: list[Point] = []
        self.feet: list[tuple[int, int]] = []
        self.narrow: list[tuple[int, int]] = []
        self.value: mpq | None = None

    def band(self, tried: set[tuple[object, ...]]) -> Band | None:
        """Return the triangulation, if it is one and not of those tried before."""
        if len(self.cycle) <= _SMALL:
            part = _best_without_new_vertices(self.cycle, [self.at[v] for v in self.cycle])
            if part.value >= self.wanted or len(self.cycle) == 3:
                self._take(part)
                return self._made()
        while self._cut_ear():
            pass
        key = (self.steep, *self.cycle)
        if key in tried:
            return None
        tried.add(key)
        self._triangulate()
        return self._made()

    def _made(self) -> Band | None:
        if self.value is None or self.value <= 0:
            return None
        return Band(self.value, tuple(self.faces), tuple(self.new), tuple(self.feet), tuple(self.narrow))

    def _triangulate(self) -> None:
        low, up = self._chains()
        if any(self.at[u] >= self.at[v] for chain in (low, up) for u, v in pairwise(chain)):
            self.value = None
            return
        order = sorted([(self.at[v], -TOP, v) for v in up[1:-1]] + [(self.at[v], -BOTTOM, v) for v in low[1:-1]])
        runs = [(-side, [v for _, _, v in run]) for side, run in groupby(order, key=lambda item: item[1])]
        left = {TOP: low[0], BOTTOM: low[0]}
        for i, (side, run) in enumerate(runs):
            closing = runs[i + 1][1][0] if i + 1 < len(runs) else low[-1]
            # The first of a run may be the end of the edge that closed the last one.
            self._add_one_sided([left[side], *(v for v in run if v != left[side])], left[-side], closing, side)
            left[side], left[-side] = run[-1], closing

    def _chains(self) -> tuple[list[int], list[int]]:
        """Return the lower and the upper chain from the first vertex to the last one, in lexicographic order."""
        cycle, count = self.cycle, len(self.cycle)
        first = min(range(count), key=lambda i: self.at[cycle[i]])
        last = max(range(count), key=lambda i: self.at[cycle[i]])
        low = [cycle[(first + k) % count] for k in range((last - first) % count + 1)]
        up = [cycle[(first - k) % count] for k in range((first - last) % count + 1)]
        return low, up

    def _cut_ear(self) -> bool:
        """Cut off one ear at a step that turns back or is steep; return whether there was one."""
        if len(self.cycle) == 3:
            return False
        low, up = self._chains()
        for side, chain in ((BOTTOM, low), (TOP, up)):
            for i, (p, q) in enumerate(pairwise(chain)):
                step = self.at[q].x - self.at[p].x
                is_end = i == 0 or i + 2 == len(chain)
                if self.at[p].y == self.at[q].y or (step >= 0 if is_end else step >= self.reach and step > 0):
                    continue
                for j in (i, i + 1) if side == TOP else (i + 1, i):
                    if 0 < j < len(chain) - 1 and self._is_ear(chain, j, side, step < 0):
                        return True
        return False

    def _is_ear(self, chain: Sequence[int], j: int, side: int, turns_back: bool) -> bool:
        """Cut off vertex j of a chain with its neighbours if that is a good triangle without others in it."""
        ear = (chain[j - 1], chain[j], chain[j + 1])
        a, b, c = (self.at[v] for v in (ear if side == BOTTOM else ear[::-1]))
        if not turns_back and abs(c.x - a.x) > _LONG_EAR * self.ground.level and side not in self.long_ears:
            return False
        value = height_squared(a, b, c)
        if value < self.wanted or any(_contains(a, b, c, self.at[v]) for v in self.cycle if v not in ear):
            return False
        self._take(_Part(value, [ear if side == BOTTOM else ear[::-1]]))
        self.cycle.remove(chain[j])
        return True

    def _take(self, part: _Part) -> None:
        """Keep the triangulation of a part."""
        first = len(self.ground.points) + len(self.new)
        self.new += part.new
        self.faces += [tuple(v if v >= 0 else first - 1 - v for v in face) for face in part.faces]
        self.feet += [(edge, first - 1 - v) for edge, v in part.feet]
        self.value = part.value if self.value is None else min(self.value, part.value)

    def _add_one_sided(self, t_side: Sequence[int], a: int, b: int, side: int) -> None:
        """Triangulate the band between a chain, at the top or at the bottom, and the clean edge from a to b."""
        chain = [v for v in t_side if v not in (a, b)]
        if not chain:
            return
        ring = [a, b, *reversed(chain)] if side == TOP else [b, a, *chain]
        key = (self.steep, *ring)
        if key not in self.ground.parts:
            best = _Part(mpq(0), [])
            for part in self._parts(chain, a, b, side, ring):
                if part.value > best.value:
                    best = part
                    if best.value >= self.wanted:
                        break
            self.ground.parts[key] = best
        best = self.ground.parts[key]
        if best.value < self.wanted:
            self.narrow.append((ring[0], ring[1]))
        self._take(best)

    def _parts(self, chain: list[int], a: int, b: int, side: int, ring: list[int]) -> Iterator[_Part]:
        """Yield triangulations of a band with a chain on one side."""
        if len(ring) <= _SMALL:
            yield _best_without_new_vertices(ring, [self.at[v] for v in ring])
        yield from self._nested(chain, a, b, side)
        edge = self.ground.edge_of(a, b)
        if edge is not None and self.at[a].x != self.at[b].x:
            yield from self._with_feet(chain, a, b, side, edge)

    def _nested(self, chain: list[int], a: int, b: int, side: int) -> Iterator[_Part]:
        """Yield nested triangles over the chain, once ears are cut off where its ends are steep."""
        chain, ears, low = self._without_steep_ends(chain, side)
        names = [*chain, a, b]
        for base in sorted({self.at[v].y for v in chain}, reverse=side == BOTTOM)[:_BASES]:
            u = [Point(self.at[v].x, side * (base - self.at[v].y)) for v in names]
            if len(chain) < 2 or any(p.x >= q.x for p, q in pairwise(u[:-2])):
                return
            frame = Frame(tuple(p.x for p in u[:-2]), u[-2], u[-1], Point(mpq(0), base), Point(mpq(1), mpq(0)),
                          side == TOP, tuple(p.y for p in u[:-2]))
            for trial in nested_trials(frame):
                found = trial.candidate(frame)
                if found.value > 0:
                    piece = frame.piece(found.faces, found.steiner)
                    faces = [tuple(names[v] if v >= 0 else v for v in face) for face in piece.faces]
                    yield _Part(found.value if low is None else min(low, found.value), faces + ears, piece.steiner)

    def _without_steep_ends(self, chain: list[int], side: int) -> tuple[list[int], list[Cycle], mpq | None]:
        """Return the chain less its second and next vertices, from either end, while it is steep there; the ears that
        are cut off, and the least of their squared heights."""
        rest, ears, low = list(chain), [], None
        reach = self.steep / 2
        for from_right in (False, True):
            if from_right:
                rest.reverse()
            while len(rest) > 2 and abs(self.at[rest[1]].x - self.at[rest[0]].x) < reach:
                ear: Cycle = tuple(rest[:3] if (side == TOP) == from_right else rest[2::-1])
                value = height_squared(*(self.at[v] for v in ear))
                if self.at[rest[0]].y == self.at[rest[1]].y or value < self.wanted:
                    break
                ears.append(ear)
                low = value if low is None else min(low, value)
                del rest[1]
        rest.reverse()
        return rest, ears, low

    def _with_feet(self, chain: list[int], a: int, b: int, side: int, edge: int) -> Iterator[_Part]:
        """Yield the triangulation that drops the chain on the clean edge, but for what is near or beyond its ends."""
        start, end = self.at[a], self.at[b]
        reach = self.steep
        inner = [i for i, v in enumerate(chain) if start.x + reach <= self.at[v].x <= end.x - reach]
        if not inner:
            return
        slope = (end.y - start.y) / (end.x - start.x)
        dropped = range(inner[0], inner[-1] + 1)
        new = [Point(x, start.y + slope * (x - start.x)) for x in (self.at[chain[i]].x for i in dropped)]
        foot = {i: -1 - number for number, i in enumerate(dropped)}
        first, last = dropped[0], dropped[-1]
        outlines: list[Cycle] = [(a, chain[j + 1], chain[j]) for j in range(first - 1)]
        outlines += [(a, foot[first], chain[first], *chain[first - 1 : first])]
        outlines += [(foot[i], foot[i + 1], chain[i + 1], chain[i]) for i in dropped[:-1]]
        outlines += [(foot[last], b, *chain[last + 1 : last + 2], chain[last])]
        outlines += [(b, chain[j + 1], chain[j]) for j in range(last + 1, len(chain) - 1)]
        faces: list[Cycle] = []
        least: mpq | None = None
        for outline in outlines:
            names = list(outline if side == TOP else outline[::-1])
            corners = [self.at[v] if v >= 0 else new[-1 - v] for v in names]
            piece = quad([corners[0], *corners[-3:]], self.wanted)
            names = [names[0], *names[-3:], *(-1 - len(new) - i for i in range(len(piece.steiner) - 1, -1, -1))]
            new += piece.steiner
            for face in piece.faces:
                cycle = tuple(names[v] for v in face)
                value = height_squared(*(self.at[v] if v >= 0 else new[-1 - v] for v in cycle))
                least = value if least is None else min(least, value)
                faces.append(cycle)
        if least is not None:
            yield _Part(least, faces, new, [(edge, v) for v in foot.values()])


def _contains(a: Point, b: Point, c: Point, p: Point) -> bool:
    return bool(doubled_area(a, b, p) >= 0 and doubled_area(b, c, p) >= 0 and doubled_area(c, a, p) >= 0)


def _best_without_new_vertices(names: Sequence[int], ring: Sequence[Point]) -> _Part:
    """Return the triangulation with the greatest least height (Klincsek's dynamic program, on exact values).

    No visibility is tested: triangles that all turn left over the whole boundary tile it, and others count as bad.
    """
    count = len(ring)
    best: dict[tuple[int, int], mpq | None] = {(i, i + 1): None for i in range(count - 1)}
    third: dict[tuple[int, int], int] = {}
    for length in range(2, count):
        for i in range(count - length):
            j = i + length
            greatest: mpq | None = None
            for k in range(i + 1, j):
                value = height_squared(ring[i], ring[k], ring[j])
                value = min([value, *(v for v in (best[i, k], best[k, j]) if v is not None)])
                if greatest is None or value > greatest:
                    greatest, third[i, j] = value, k
            best[i, j] = greatest
    faces: list[Cycle] = []
    pending = [(0, count - 1)]
    while pending:
        i, j = pending.pop()
        if j > i + 1:
            k = third[i, j]
            faces.append((names[i], names[k], names[j]))
            pending += [(i, k), (k, j)]
    return _Part(best[0, count - 1] or mpq(0), faces)
