"""Triangulate the Interior properly, with vertices passed on to the Tube and from there to P (for Theorem 3).

In      `Offset`, `Trapezoidation`, and the points of all vertices so far.
Out     `Patch`; `on_edge` has all vertices put on edges of Q.
Exact   rational.
Paper   says that only the Tube's rectangles are not proper; but trapezoids carry T-vertices as well.
Check   `patch_check.py`

Every T-vertex on a top side sends a vertical edge down through its room, every one on a bottom side that has none
sends one up. An edge ends at a vertex of the opposite chain within `MERGE` of its line, else at a new vertex: on an
edge of Q, where it is recorded, or on a chord, where it goes on in the next room. What is left between two edges is a
polygon with few vertices. The number of vertices is not linear: an edge may cross many chords.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise
from typing import TypeVar

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.steps.constants import MERGE
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Patch, Piece, Trapezoidation
from exactmesh.steps.rooms import BOTTOM, CHORD, TOP, Room, rooms_of
from exactmesh.steps.small_polygon import triangulate_small


def triangulate_in_columns(offset: Offset, trapezoidation: Trapezoidation, points: Sequence[Point]) -> Patch:
    """Return a proper triangulation of all trapezoids; `points` has the vertices of P, Q and the chord ends."""
    return _Columns(offset, trapezoidation, points).run()


_Run = tuple[mpq, mpq]


class _Columns:
    """All rooms, and what lies beyond their chords."""

    def __init__(self, offset: Offset, trapezoidation: Trapezoidation, points: Sequence[Point]) -> None:
        self.offset = offset
        self.mesh = PatchBuilder(points, proper=True)
        self.rooms = rooms_of(self.mesh, offset, trapezoidation)
        self.across: dict[int, list[tuple[int, int]]] = defaultdict(list)
        # By side and level, from left to right: the stretch of each room's chord; by level: horizontal edges of Q.
        self.chords: dict[tuple[int, int], list[tuple[_Run, Room]]] = defaultdict(list)
        for room in self.rooms:
            for t in (TOP, BOTTOM):
                if (stretch := self._chord(room, t)) is not None:
                    self.chords[t, room.level(t)].append((stretch, room))
        self.flat: dict[int, list[tuple[_Run, int]]] = defaultdict(list)
        for k, following in enumerate(offset.successors()):
            if offset.level[k] == offset.level[following]:
                low, high = sorted((offset.x[k], offset.x[following]))
                self.flat[offset.level[k]].append(((low, high), k))
        for rows in self.chords.values():
            rows.sort(key=lambda row: row[0])
        for flats in self.flat.values():
            flats.sort()

    def run(self) -> Patch:
        for t in (TOP, BOTTOM):
            # From the top down for top sides, then from the bottom up.
            for room in sorted(self.rooms, key=lambda room: -t * room.level(t)):
                self._link(room, t)
        for room in self.rooms:
            self._fill(room)
        return self.mesh.finished()

    def _x(self, v: int) -> mpq:
        return self.mesh.points[v].x

    def _chord(self, room: Room, t: int) -> _Run | None:
        xs = [self._x(v) for i, kind in enumerate(room.along[t]) if kind == CHORD for v in room.chain[t][i : i + 2]]
        return (min(xs), max(xs)) if xs else None

    def _link(self, room: Room, t: int) -> None:
        """Send an edge across the room from every vertex of chain t that must not stay as it is."""
        across = self.across[id(room)]
        met = {pair[t == BOTTOM] for pair in across}
        for place in range(1, len(room.chain[t]) - 1):
            v = room.chain[t][place]
            if v not in met and self._needs_edge(room, t, place):
                end = self._end(room, t, place)
                across.append((v, end) if t == TOP else (end, v))

    def _needs_edge(self, room: Room, t: int, place: int) -> bool:
        """Return whether the angle of the room is 180 degrees or more; a vertex inside an edge of Q may stay."""
        before, after = room.along[t][place - 1 : place + 1]
        if before == after and before >= 0:
            return False
        a, b, c = (self.mesh.points[v] for v in room.chain[t][place - 1 : place + 2])
        return t * orientation(a, b, c) >= 0

    def _end(self, room: Room, t: int, place: int) -> int:
        """Return the vertex of the opposite chain at which the edge from a vertex of chain t ends."""
        own, chain = room.chain[t], room.chain[-t]
        v, x = own[place], self._x(own[place])
        first = bisect_left(chain, x - MERGE, key=self._x)
        last = bisect_right(chain, x + MERGE, key=self._x)
        near = [u for u in chain[first:last] if u not in (own[place - 1], own[place + 1])]
        if near:
            # Of two vertices straight above each other the one nearer to v is seen.
            return min(near, key=lambda u: (abs(self._x(u) - x), abs(self.mesh.points[u].y - self.mesh.points[v].y)))
        at = bisect_left(chain, x, key=self._x) - 1
        a, b = self.mesh.points[chain[at]], self.mesh.points[chain[at + 1]]
        new = self.mesh.add(Point(x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)))
        edge = room.along[-t][at]
        room.insert(-t, at, new)
        if edge >= 0:
            self.mesh.on_edge.append((edge, new))
        else:
            self._hand_on(new, x, -t, room.level(-t))
        return new

    def _hand_on(self, v: int, x: mpq, t: int, level: int) -> None:
        """Tell what lies beyond side t at a new vertex: another room, or a horizontal edge of Q."""
        if (beyond := _covering(self.chords[-t, level], x)) is not None:
            place = bisect_left(beyond.chain[-t], x, key=self._x) - 1
            beyond.insert(-t, place, v)
        elif (edge := _covering(self.flat[level], x)) is not None:
            self.mesh.on_edge.append((edge, v))
        else:
            raise AssertionError("a chord lies between two rooms, or along an edge of Q")

    def _fill(self, room: Room) -> None:
        """Triangulate the polygons between consecutive edges across the room."""
        top, bottom = room.chain[TOP], room.chain[BOTTOM]
        places = {t: {v: i for i, v in enumerate(room.chain[t])} for t in (TOP, BOTTOM)}
        inner = sorted((places[TOP][a], places[BOTTOM][b]) for a, b in self.across[id(room)])
        pairs = [(0, 0), *inner, (len(top) - 1, len(bottom) - 1)]
        for (t0, b0), (t1, b1) in pairwise(pairs):
            outline = list(dict.fromkeys((*bottom[b0 : b1 + 1], *top[t0 : t1 + 1][::-1])))
            if len(outline) == 4:
                self.mesh.add_quad(outline)
            elif len(outline) > 2:
                faces = triangulate_small([self.mesh.points[v] for v in outline])
                self.mesh.add_piece(Piece(faces), outline)


_Beyond = TypeVar("_Beyond")


def _covering(rows: Sequence[tuple[_Run, _Beyond]], x: mpq) -> _Beyond | None:
    """Return what covers x, of things with disjoint stretches from left to right."""
    at = bisect_right(rows, x, key=lambda row: row[0][0]) - 1
    return rows[at][1] if at >= 0 and x <= rows[at][0][1] else None
