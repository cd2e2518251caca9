"""Trapezoids as rooms for columns: polygons between a top and a bottom chain, without slivers under shallow legs.

A chord that meets a shallow leg runs close to it near its end, and no vertex may be put there. So the chord is trimmed:
it ends at a vertex k where it is `TRIM` away from the leg, straight above (or below) a new vertex k' of the leg, and
the sliver between chord and leg belongs to the room on the other side of the chord.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.constants import MERGE, TRIM
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Trapezoid, Trapezoidation

TOP, BOTTOM = 1, -1
# What lies along a piece of a chain: an edge of Q by its number, the chord of a level, or the step k k' of a trimmed
# one.
CHORD, STEP = -1, -2


@dataclass(slots=True)
class Room:
    """A room; `chain[t]` has the vertices of its top (t = 1) or bottom (t = -1) from left to right.

    `along[t][i]` tells what lies along the piece from vertex i to vertex i + 1. The two chains begin (and end) at one
    vertex, or at the ends of a vertical edge.
    """

    z: Trapezoid
    chain: dict[int, list[int]] = field(default_factory=dict)
    along: dict[int, list[int]] = field(default_factory=dict)

    def level(self, t: int) -> int:
        """Return the level of the chord on side t."""
        return self.z.high if t == TOP else self.z.low

    def insert(self, t: int, place: int, v: int) -> None:
        """Put a vertex into the piece from vertex `place` to the next one of a chain."""
        self.chain[t].insert(place + 1, v)
        self.along[t].insert(place + 1, self.along[t][place])


def rooms_of(mesh: PatchBuilder, offset: Offset, trapezoidation: Trapezoidation) -> list[Room]:
    """Return the rooms of all trapezoids with their chords trimmed; new vertices go to `mesh`."""
    rooms = [_room(mesh, z) for z in trapezoidation.trapezoids]
    _Trimming(mesh, offset, rooms).run()
    return rooms


def _room(mesh: PatchBuilder, z: Trapezoid) -> Room:
    """Return the room of a trapezoid: a leg belongs to the chain that it lies below or above."""
    room = Room(z, {TOP: [z.tl, *z.top, z.tr], BOTTOM: [z.bl, *z.bottom, z.br]})
    if z.tl == z.tr:
        room.chain[TOP] = [z.tl]
    if z.bl == z.br:
        room.chain[BOTTOM] = [z.bl]
    room.along = {t: [CHORD] * (len(room.chain[t]) - 1) for t in (TOP, BOTTOM)}
    xs = [mesh.points[v].x for v in (z.tl, z.bl, z.tr, z.br)]
    if xs[0] != xs[1]:
        t, v = (BOTTOM, z.tl) if xs[0] < xs[1] else (TOP, z.bl)
        room.chain[t].insert(0, v)
        room.along[t].insert(0, z.left)
    if xs[2] != xs[3]:
        t, v = (BOTTOM, z.tr) if xs[2] > xs[3] else (TOP, z.br)
        room.chain[t].append(v)
        room.along[t].append(z.right)
    return room


class _Trimming:
    """Trims the chord ends of all rooms, left ends first; right ends are seen in a mirror."""

    def __init__(self, mesh: PatchBuilder, offset: Offset, rooms: Sequence[Room]) -> None:
        self.mesh = mesh
        self.offset = offset
        self.following = offset.successors()
        self.rooms = rooms
        self.sign = 1

    def run(self) -> None:
        """Trim every chord that needs it, at both ends."""
        for self.sign in (1, -1):
            if self.sign < 0:
                self._mirror()
            for below, above, corner in list(self._meetings()):
                self._trim(below, above, corner)
        self._mirror()

    def _mirror(self) -> None:
        for room in self.rooms:
            for t in (TOP, BOTTOM):
                room.chain[t].reverse()
                room.along[t].reverse()

    def _meetings(self) -> Iterator[tuple[Room, Room, int]]:
        """Yield the rooms below and above each piece of a chord, and the vertex at which the piece begins."""
        starts: dict[int, dict[int, Room]] = {TOP: {}, BOTTOM: {}}
        for room in self.rooms:
            for t in (TOP, BOTTOM):
                for v, kind in zip(room.chain[t], room.along[t], strict=False):
                    if kind == CHORD:
                        starts[t][v] = room
        for v, below in starts[TOP].items():
            if v in starts[BOTTOM]:
                yield below, starts[BOTTOM][v], v

    def _trim(self, below: Room, above: Room, corner: int) -> None:
        legs = self._legs_beside(below, above, corner, 0)
        if not legs:
            return
        # Where both legs run on beside the chord the sliver over the shallower one joins the room of the other.
        reach, room, t, leg = max(legs, key=lambda option: option[0])
        k = self._end_of_chord(below, above, corner, reach) if reach > MERGE else None
        if k is None:
            return
        foot = self._foot(leg, k)
        self._replace(room, -t, corner, k)
        self._replace(room, t, corner, foot)
        other = above if t == BOTTOM else below
        place = other.chain[t].index(corner)
        if other.chain[t][place + 1] != k:
            other.insert(t, place, k)
        other.insert(t, place, foot)
        other.along[t][place : place + 2] = [leg, STEP]

    def _legs_beside(self, below: Room, above: Room, v: int, end: int) -> list[tuple[mpq, Room, int, int]]:
        """Return the legs that run on below (t = -1) or above the chord from its vertex v, the first (end = 0) or last
        (end = -1) one of the rooms: the reach of the sliver between leg and chord, the leg's room, t, its edge of Q."""
        return [(TRIM / abs(self._slope(room.along[t][end])), room, t, room.along[t][end])
                for room, t in ((below, BOTTOM), (above, TOP)) if room.chain[t][end] == v and room.along[t][end] >= 0]

    def _slope(self, edge: int) -> mpq:
        a, b = self._ends(edge)
        return (b.y - a.y) / (b.x - a.x)

    def _ends(self, edge: int) -> tuple[Point, Point]:
        return self.offset.points[edge], self.offset.points[self.following[edge]]

    def _end_of_chord(self, below: Room, above: Room, corner: int, reach: mpq) -> int | None:
        """Return the vertex at which the trimmed chord ends: a new one, or the next one of the chord when that is near.

        In the latter case nothing is left of this piece of the chord. Where slivers from both ends do not fit, the
        longer one that ends within the piece takes it all: two legs on either side of a piece are `SEPARATION` apart,
        so that one between them would leave a vertex near the other leg (a strip 8 vertices long had degradation 65).
        None when the piece is left to its other end.
        """
        following = below.chain[TOP][below.chain[TOP].index(corner) + 1]
        length = abs(self.mesh.points[following].x - self.mesh.points[corner].x)
        opposite = max((leg[0] for leg in self._legs_beside(below, above, following, -1)), default=mpq(0))
        if opposite <= MERGE:
            opposite = mpq(0)
        if length > reach + opposite + MERGE:
            start = self.mesh.points[corner]
            return self.mesh.add(Point(start.x + self.sign * reach, start.y))
        return following if length >= reach and not reach < opposite <= length else None

    def _foot(self, edge: int, k: int) -> int:
        a, _ = self._ends(edge)
        x = self.mesh.points[k].x
        foot = self.mesh.add(Point(x, a.y + self._slope(edge) * (x - a.x)))
        self.mesh.on_edge.append((edge, foot))
        return foot

    @staticmethod
    def _replace(room: Room, t: int, corner: int, v: int) -> None:
        """Let a chain begin at v instead of the corner; v may be the next vertex already."""
        if room.chain[t][1] == v:
            del room.chain[t][0], room.along[t][0]
        else:
            room.chain[t][0] = v
