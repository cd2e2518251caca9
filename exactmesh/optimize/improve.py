"""Improve a mesh where it is worst, until its mfs cannot be raised by the moves at hand; then thin it out.

The mfs of a mesh is the least over its faces, so the worst face is changed for the better again and again. When no
move changes it, the faces around it are improved: it may then have room. What a move is worth is decided in
`Faces.replace`; here is only the order in which moves are tried, and when to give up.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt
from typing import Literal

from gmpy2 import mpq

from exactmesh.optimize.faces import Faces
from exactmesh.optimize.moves import Moves
from exactmesh.planar.cycles import sides

Reason = Literal["target", "no move helps", "effort", "time", "interrupted"]
# Floats should promise this much more than what is to be reached, relatively: their errors are far smaller.
_MARGIN = 1e-9
# Gains below this, relatively, are not worth a step; nor below this share of what is left to the goal.
_GAIN, _SHARE = 2e-3, 0.25
_WORTHWHILE, _NEARLY = 1.01, 0.95
# Rings of faces around the worst one that are improved when it cannot be, and how often.
_RINGS = (2, 4, 6)
_PASSES = 4
_THINNINGS = 4


@dataclass(frozen=True, slots=True)
class Effort:
    """When to give up: after so many `tries`; or after `patience` tries that changed their face by less than 1% or not
    at all, while the mfs rose by less than 1%, a quarter of that within 1% of the goal; or when `is_late()`."""

    tries: float
    patience: float
    is_late: Callable[[], bool] = lambda: False


class Improver:
    """Raises the least squared feature size of `faces` towards `goal`."""

    def __init__(self, faces: Faces, goal: mpq, effort: Effort, progress: Callable[[str], None] = lambda step: None
                 ) -> None:
        self.faces = faces
        self.goal = goal
        self.tries = 0
        self._effort = effort
        self._progress = progress
        self._cap = sqrt(float(goal)) * (1 + _MARGIN)
        # Faces that no move improved since something changed around them.
        self._stuck: set[int] = set()
        self._wasted = 0
        self._reached = 0.0

    def run(self) -> Reason:
        """Improve the worst face until the goal is reached, or no move helps, or the effort is spent."""
        faces = self.faces
        self._make_stars()
        while True:
            worst = faces.worst()
            if faces.feature[worst] >= self.goal:
                return "target"
            if reason := self._spent():
                return reason
            if not self._improve(worst) and not any(self._relax(worst, rings) for rings in _RINGS):
                return self._spent() or "no move helps"

    def _make_stars(self) -> None:
        """Where one star over a whole face of the input nearly reaches the goal, take it: what is round needs no more,
        and would need many steps. Poorer ones would only be in the way of better meshes."""
        faces = self.faces
        seen: set[int] = set()
        for start in list(faces.cycle):
            part = [start] if start not in seen else []
            seen.add(start)
            for face in part:
                across = {faces.neighbour(side) for side in sides(faces.cycle[face])} - seen
                part += (found := sorted(other for other in across if other is not None))
                seen.update(found)
            least = min((faces.feature[face] for face in part), default=self.goal)
            if least < self.goal:
                moves = Moves(faces, faces.cycle[start][0], max(_NEARLY * self._cap, (1 + _GAIN) * sqrt(float(least))),
                              self._cap)
                if proposal := moves.starred(part):
                    faces.replace(proposal.old, proposal.new, proposal.centre)

    def _spent(self) -> Reason | None:
        if self._effort.is_late():
            return "time"
        height = sqrt(float(self.faces.feature[self.faces.worst()]))
        if height > _WORTHWHILE * self._reached:
            self._wasted, self._reached = 0, height
        # Near the goal no gain is worthwhile any more.
        patience = self._effort.patience if _WORTHWHILE * height < self._cap else self._effort.patience / 4
        return "effort" if self._wasted > patience or self.tries > self._effort.tries else None

    def _improve(self, face: int) -> bool:
        """Change a face for the better, by the best proposal that is accepted; return whether there is one."""
        if face in self._stuck:
            return False
        faces = self.faces
        self.tries += 1
        self._wasted += 1
        if not self.tries % 64:
            self._progress(f"optimisation: {self.tries} places tried, {faces.steps} steps")
        height = sqrt(float(faces.feature[face]))
        low = height + min(_GAIN * height, _SHARE * max(0.0, self._cap - height))
        moves = Moves(faces, faces.cycle[face][0], low, self._cap)
        refused = []
        for proposal in moves.for_face(face):
            if proposal.value < self._cap:
                refused.append(proposal)
            elif made := faces.replace(proposal.old, proposal.new, proposal.centre):
                return self._changed(made, height)
        for proposal in sorted(refused, key=lambda proposal: -proposal.value):
            if made := faces.replace(proposal.old, proposal.new, proposal.centre):
                return self._changed(made, height)
        self._stuck.add(face)
        return False

    def _changed(self, made: list[int], before: float) -> bool:
        faces = self.faces
        if sqrt(float(min(faces.feature[face] for face in made))) > _WORTHWHILE * before:
            self._wasted -= 1
        for v in {v for face in made for v in faces.cycle[face]}:
            self._stuck -= faces.around[v]
        return True

    def _relax(self, worst: int, rings: int) -> bool:
        """Improve the faces around the worst one until it is another; return whether it is."""
        faces = self.faces
        least = faces.feature[worst]
        vertices = set(faces.cycle[worst])
        for _ in range(rings):
            vertices = {v for u in vertices for face in faces.around[u] for v in faces.cycle[face]}
        for _ in range(_PASSES):
            some = False
            near = {face for v in vertices for face in faces.around[v]}
            for _, face in sorted((faces.feature[face], face) for face in near):
                if self._spent():
                    return bool(faces.feature[faces.worst()] > least)
                if face in faces.feature and faces.feature[face] < self.goal and self._improve(face):
                    some = True
                    if worst not in faces.feature or (worst not in self._stuck and self._improve(worst)):
                        return True
            if not some:
                return False
        return False


def thin_out(faces: Faces, mfs_squared: mpq, is_late: Callable[[], bool] = lambda: False) -> None:
    """Remove Steiner vertices, and put one in the place of two, while all faces keep the squared feature size."""
    cap = sqrt(float(mfs_squared)) * (1 + _MARGIN)
    for _ in range(_THINNINGS):
        before = faces.steps
        for v in sorted(v for v, around in faces.around.items() if around and v >= faces.given):
            if is_late():
                return
            if faces.around[v]:
                _without(faces, v, mfs_squared, cap)
        if faces.steps == before:
            return


def _without(faces: Faces, v: int, mfs_squared: mpq, cap: float) -> bool:
    """Remove a Steiner vertex, or merge it with one beside it; return whether that was possible."""
    moves = Moves(faces, v, (1 - _MARGIN) * cap, cap)
    star = faces.around[v]
    beside = sorted({u for face in star for u in faces.cycle[face] if u >= faces.given and u != v})
    regions = [star, moves.widened(star)]
    proposals = [moves.retriangulated(region) for region in regions]
    proposals += [moves.starred(star | faces.around[u]) for u in beside]
    return any(proposal and faces.replace(proposal.old, proposal.new, proposal.centre, mfs_squared)
               for proposal in proposals)
