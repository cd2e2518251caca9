"""A mesh that changes face by face, exactly; the one place where a proposal of the optimiser is judged.

`Faces.replace` puts new faces in the place of old ones. It accepts them when, decided by rational arithmetic alone,

R1  each new face is a counter-clockwise triangle (it may list T-vertices), none of its sides occurs twice;
R2  the sides that bound the old faces together, and the sides of the input between them, are those of the new ones;
R3  the vertices of the input on the old faces are on the new ones;
R4  the least feature size of the new faces is greater than that of the old ones, or at least what the caller asks for.

By R1 and R2 the new faces have the same boundary as the old, all turned the same way, so they tile the same region
(the argument of `exactmesh.measure.validity`). By R4 the mfs of the mesh, the least over its faces and of the input's,
never falls. Nothing that a proposal was made with, floats above all, has to be trusted.

An interrupt may come at any moment: a change is recorded before it is made, and `settle` makes it whole.
"""

from collections.abc import Collection, Iterable, Sequence
from heapq import heapify, heappop, heappush

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.planar.cycles import Cycle, Side, sides

_Change = tuple[tuple[int, ...], list[tuple[int, Cycle, mpq]], list[tuple[int, Point]]]


class Faces:
    """The faces of a mesh by number, with their exact squared feature sizes, the worst one first.

    `point[v]` is a vertex, those below `given` belong to the input; `owner` gives the face on the left of a directed
    side, `around[v]` the faces with vertex v. `constrained` holds both directions of the input's edges.
    """

    def __init__(self, points: Iterable[Point], given: int, constrained: Collection[Side], cycles: Iterable[Cycle]
                 ) -> None:
        self.point = dict(enumerate(points))
        self.given = given
        self.constrained = constrained
        self.cycle: dict[int, Cycle] = {}
        self.feature: dict[int, mpq] = {}
        self.owner: dict[Side, int] = {}
        self.around: dict[int, set[int]] = {v: set() for v in self.point}
        self.steps = 0
        self._next_face = 0
        self._next_vertex = len(self.point)
        self._pending: _Change | None = None
        self._heap: list[tuple[mpq, int]] = []
        for cycle in cycles:
            feature = self._feature(cycle, self.point)
            if feature is None:
                raise ValueError(f"the cycle {cycle} is no counter-clockwise triangle")
            self._insert(self._next_face, cycle, feature)
            self._next_face += 1
        self._heap = [(feature, face) for face, feature in self.feature.items()]
        heapify(self._heap)

    def worst(self) -> int:
        """Return the face with the least feature size, the oldest among equals."""
        while True:
            feature, face = self._heap[0]
            if self.feature.get(face) == feature:
                return face
            heappop(self._heap)

    def ring(self, faces: Collection[int]) -> list[int] | None:
        """Return the vertices around the union of some faces, counter-clockwise; None when that is not one walk.

        The input's edges are never crossed: one between two of the faces is walked on both sides.
        """
        onward: dict[int, list[int]] = {}
        count = 0
        for u, v in self.rim(faces):
            onward.setdefault(u, []).append(v)
            count += 1
        if len(onward) < count:
            return None  # a vertex is passed twice
        start = at = next(iter(onward))
        ring = []
        while True:
            ring.append(at)
            at = onward[at][0]
            if at == start:
                return ring if len(ring) == count else None

    def rim(self, faces: Collection[int]) -> set[Side]:
        """Return the directed sides around the union of some faces, and those along the input's edges between them."""
        return rim_of((self.cycle[face] for face in faces), self.constrained)

    def neighbour(self, side: Side) -> int | None:
        """Return the face across a directed side; None across an edge of the input."""
        return None if side in self.constrained else self.owner.get((side[1], side[0]))

    def replace(self, old: Collection[int], new: Sequence[Cycle], added: Sequence[Point] = (),
                at_least: mpq | None = None) -> list[int] | None:
        """Put `new` in the place of the faces `old`; return the numbers of the new faces, None when refused (R1 to R4).

        `new` may use the vertices -1, -2, .. for the points `added`. Without `at_least` the new faces must be better
        than the old.
        """
        bound = min(self.feature[face] for face in old) if at_least is None else at_least
        names = {-1 - i: self._next_vertex + i for i in range(len(added))}
        cycles = [tuple(names.get(v, v) for v in cycle) for cycle in new]
        place = {self._next_vertex + i: point for i, point in enumerate(added)}
        kept = {v for face in old for v in self.cycle[face] if v < self.given}
        directed = [side for cycle in cycles for side in sides(cycle)]
        if len(set(directed)) < len(directed) or self.rim(old) != rim_of(cycles, self.constrained):
            return None
        if not kept.issubset(v for cycle in cycles for v in cycle):
            return None
        known = {v: self.point[v] if v in self.point else place[v] for cycle in cycles for v in cycle}
        measured = []
        for number, cycle in enumerate(cycles, self._next_face):
            feature = self._feature(cycle, known)
            if feature is None or feature < bound or (at_least is None and feature == bound):
                return None
            measured.append((number, cycle, feature))
        self._pending = tuple(old), measured, list(place.items())
        self.settle()
        return [number for number, _, _ in measured]

    def settle(self) -> None:
        """Make a change that was interrupted whole; without one, do nothing."""
        if self._pending is None:
            return
        old, new, added = self._pending
        for v, point in added:
            self.point[v] = point
            self.around.setdefault(v, set())
        for face in old:
            for side in sides(self.cycle.get(face, ())):
                if self.owner.get(side) == face:
                    del self.owner[side]
            for v in self.cycle.get(face, ()):
                self.around[v].discard(face)
        for face in old:
            self.cycle.pop(face, None)
            self.feature.pop(face, None)
        for face, cycle, feature in new:
            self._insert(face, cycle, feature)
            heappush(self._heap, (feature, face))
        self._next_face = new[-1][0] + 1
        self._next_vertex = max([self._next_vertex, *(v + 1 for v, _ in added)])
        self.steps += 1
        self._pending = None

    def _insert(self, face: int, cycle: Cycle, feature: mpq) -> None:
        self.cycle[face] = cycle
        self.feature[face] = feature
        for side in sides(cycle):
            self.owner[side] = face
        for v in cycle:
            self.around[v].add(face)

    @staticmethod
    def _feature(cycle: Cycle, points: dict[int, Point]) -> mpq | None:
        """Return the squared feature size of a face; None when it is no counter-clockwise triangle."""
        place = [points[v] for v in cycle]
        numbered = tuple(range(len(cycle)))
        corners = corners_of(place, numbered)
        return None if isinstance(corners, NotTriangle) else face_feature_squared(place, numbered, corners)


def rim_of(cycles: Iterable[Cycle], constrained: Collection[Side]) -> set[Side]:
    """Return the directed sides of cycles without a twin among them, and all those along the input's edges."""
    directed = {side for cycle in cycles for side in sides(cycle)}
    return {side for side in directed if side in constrained or (side[1], side[0]) not in directed}
