"""Proposals around one face: other triangles on the same vertices, and stars around one Steiner vertex.

A region is a set of faces whose ring is one walk. It is triangulated anew without the vertices inside (flips, removed
vertices, more than that), or as a star around a new vertex (inserted, moved and merged ones). All on floats:
`Faces.replace` judges.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from math import hypot, inf

from exactmesh.geometry.point import Point
from exactmesh.optimize.faces import Faces
from exactmesh.optimize.local import Local
from exactmesh.optimize.place import Spot, best_places, height
from exactmesh.optimize.pockets import best_triangles
from exactmesh.planar.cycles import Cycle, Side, sides

_POCKET = 14
_STAR = 24
_PATIENCE = 6
# A spot is only a start: a fan from there may be this much lower than what is wanted.
_SLACK = 0.3
# Distances, about in units of the mfs, at which a new vertex is tried beside a side or a corner.
_BESIDE = (0.5, 1.0, 2.0)


@dataclass(frozen=True, slots=True)
class Proposal:
    """New faces for old ones, with the least height they are thought to have; vertex -1 is `centre`."""

    value: float
    old: frozenset[int]
    new: tuple[Cycle, ...]
    centre: tuple[Point, ...] = ()


class Moves:
    """The proposals around one vertex of a mesh. Heights count up to `cap`; what does not exceed `low` is left out."""

    def __init__(self, faces: Faces, origin: int, low: float, cap: float) -> None:
        self.faces = faces
        self.low, self.cap = low, cap
        self._local = Local(faces, origin)
        self._seen: dict[frozenset[int], float] = {}

    def for_face(self, face: int) -> Iterator[Proposal]:
        """Yield proposals that change a face, the cheap ones first."""
        faces = self.faces
        found: list[Proposal | None] = []
        region = {face}
        while len(region) <= _POCKET - 2 and len(wider := self.widened(region)) > len(region):
            region = wider
            found.append(self.retriangulated(region))
        yield from filter(None, found)
        for v in faces.cycle[face]:
            if v >= faces.given:
                star = faces.around[v]
                yield from filter(None, (self.retriangulated(star), self.starred(star), self.retriangulated(
                    self.widened(star)), self._star_from(star, self._local[v])))
        for spot in self._spots(face):
            if proposal := self._star_from({face}, spot):
                yield proposal

    def retriangulated(self, old: Collection[int]) -> Proposal | None:
        """Return the best triangles on the vertices around some faces; vertices between them go."""
        ring = self.faces.ring(old) if len(old) <= 2 * _POCKET else None
        if ring is None or not 3 <= len(ring) <= _POCKET:
            return None
        value, triangles = best_triangles([self._local[v] for v in ring], self.low, self.cap)
        if not triangles:
            return None
        return Proposal(value, frozenset(old), tuple((ring[i], ring[k], ring[j]) for i, k, j in triangles))

    def starred(self, old: Collection[int], low: float = 0.0) -> Proposal | None:
        """Return the best star over the ring of some faces, when it exceeds `low` too."""
        key = frozenset(old)
        low = max(low, self.low)
        # What is known of the region: no star, or the same one again, exceeds this.
        if self._seen.get(key, inf) <= low:
            return None
        ring = self.faces.ring(key)
        value, region = best_places([self._local[v] for v in ring], low, self.cap) if ring else (0.0, [])
        centre = self._local.simple_point(region) if region else None
        self._seen[key] = value
        if ring is None or centre is None:
            return None
        return Proposal(value, key, tuple((-1, u, v) for u, v in sides(tuple(ring))), (centre,))

    def widened(self, region: Collection[int]) -> set[int]:
        """Return the faces of a region and those across its rim."""
        faces = self.faces
        across = {faces.neighbour(side) for face in region for side in sides(faces.cycle[face])}
        return {*region, *(face for face in across if face is not None)}

    def _star_from(self, seed: Collection[int], spot: Spot) -> Proposal | None:
        """Return the best star found around a place: the best of the regions that grow from it, again from there."""
        best: Proposal | None = None
        for _ in range(2):
            region = self._grown(seed, spot)
            found = self.starred(region, best.value if best else 0.0) if region else None
            if found is None:
                break
            best = found
            if best.value >= self.cap:
                break
            spot = self._local.spot(found.centre[0])
        return best

    def _grown(self, seed: Collection[int], spot: Spot) -> list[int]:
        """Return the best region for a fan from a place, none when all are low.

        Where the fan over the rim is lowest the face across is taken in, until an edge of the input forbids it.
        """
        faces, local = self.faces, self._local
        grown, inside, pending = list(seed), set(seed), list(seed)
        most, best, waited = _SLACK * self.low, 0, 0
        least_fixed = self.cap
        rim: dict[Side, float] = {}
        while waited <= _PATIENCE and len(rim) <= _STAR:
            for u, v in (side for face in pending for side in sides(faces.cycle[face])):
                if (u, v) in faces.constrained:
                    least_fixed = min(least_fixed, height(local[u], local[v], spot))
                elif (v, u) in rim:
                    del rim[v, u]
                else:
                    rim[u, v] = height(local[u], local[v], spot)
            side = min(rim, key=rim.__getitem__, default=None)
            least = least_fixed if side is None else min(least_fixed, rim[side])
            waited += 1
            if least > most:
                most, best, waited = least, len(grown), 0
            if side is None or least >= least_fixed or least_fixed <= most:
                break
            face = faces.owner[side[1], side[0]]
            if face in inside:
                break  # around a vertex that only this region has
            inside.add(face)
            grown.append(face)
            pending = [face]
        return grown[:best]

    def _spots(self, face: int) -> Iterator[Spot]:
        """Yield places for a new vertex: in the face, beside its shortest side, beyond its longest side."""
        corners = [self._local[v] for v in self.faces.cycle[face]]
        count = len(corners)
        lengths = [hypot(x - corners[i - 1][0], y - corners[i - 1][1]) for i, (x, y) in enumerate(corners)]
        yield sum(x for x, _ in corners) / count, sum(y for _, y in corners) / count
        for i, beside in ((lengths.index(max(lengths)), False), (lengths.index(min(lengths)), True)):
            (ax, ay), (bx, by) = corners[i - 1], corners[i]
            nx, ny = (ay - by) / lengths[i], (bx - ax) / lengths[i]
            x, y = (ax + bx) / 2, (ay + by) / 2
            if not beside:
                yield x, y
                # From the opposite corner through the side.
                (x, y), nx, ny = corners[(i + 1) % count], -nx, -ny
            for distance in _BESIDE:
                yield x + distance * nx, y + distance * ny
