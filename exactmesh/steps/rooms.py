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
        legs = [(TRIM / abs(self._slope(leg)), room, t, leg) for room, t in ((below, BOTTOM), (above, TOP))
                if (leg := self._leg_along(room, t, corner)) is not None]
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

    def _leg_along(self, room: Room, t: int, corner: int) -> int | None:
        """Return the edge of Q of the room's leg at the corner when it runs on below (t = -1) or above the chord."""
        return room.along[t][0] if room.chain[t][0] == corner and room.along[t][0] >= 0 else None

    def _slope(self, edge: int) -> mpq:
        a, b = self._ends(edge)
        return (b.y - a.y) / (b.x - a.x)

    def _ends(self, edge: int) -> tuple[Point, Point]:
        return self.offset.points[edge], self.offset.points[self.following[edge]]

    def _end_of_chord(self, below: Room, above: Room, corner: int, reach: mpq) -> int | None:
        """Return the vertex at which the trimmed chord ends: the next one of the chord when it is near, or a new one.

        None when the chord is too short.
        """
        chains = (below.chain[TOP], above.chain[BOTTOM])
        following = [chain[chain.index(corner) + 1] for chain in chains]
        start = self.mesh.points[corner]
        room_left = min(abs(self.mesh.points[v].x - start.x) for v in following)
        if room_left > reach + MERGE:
            return self.mesh.add(Point(start.x + self.sign * reach, start.y))
        far_ends = (below.z.tr, above.z.br) if self.sign > 0 else (below.z.tl, above.z.bl)
        is_last = any(v in far_ends for v in following)
        return following[0] if room_left >= reach and following[0] == following[1] and not is_last else None

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
