"""Local search by exact moves on integer corners: hill climbing and annealing.

Whether a polygon is simple and which of two is worse is decided exactly. Annealing may accept a better-behaved polygon
at a chance computed in floats: that orders what is looked at next and decides nothing.
"""

import random
from collections.abc import Callable
from math import exp

from exactmesh.search.corners import Corners, is_simple, normalised
from exactmesh.search.targets import Evaluation

# Corners beyond this are not inserted; the mesh and its check take time linear in their number.
MOST_CORNERS = 16
_LARGEST = 1 << 24


def climb(start: Corners, see: Callable[[Corners], Evaluation], steps: int, source: random.Random, warmth: float = 0.0
          ) -> Corners:
    """Return the worst polygon met on a walk of `steps` evaluations from `start`; warmth 0 is hill climbing."""
    here = best = normalised(start)
    now = worst = see(here)
    for step in range(steps):
        there = move(here, source)
        if there is None:
            continue
        then = see(there)
        if then.outcome in ("skipped", "crash"):
            continue
        if then.is_worse_than(worst):
            best, worst = there, then
        if not now.is_worse_than(then) or source.random() < _chance(now, then, warmth * (1 - step / steps)):
            here, now = there, then
    return best


def move(corners: Corners, source: random.Random, attempts: int = 20) -> Corners | None:
    """Return a simple polygon one random move away, None when none is met."""
    for _ in range(attempts):
        there = normalised(source.choice(_MOVES)(corners, source))
        if there != corners and max(c for corner in there for c in corner) <= _LARGEST and is_simple(there):
            return there
    return None


def _chance(now: Evaluation, then: Evaluation, warmth: float) -> float:
    if warmth <= 0 or not now.rough:
        return 0.0
    return exp(-abs(now.rough - then.rough) / (abs(now.rough) * warmth))


def _step(corners: Corners, source: random.Random) -> int:
    """Return a distance: as often small as comparable with the whole polygon."""
    reach = max(c for corner in corners for c in corner) or 1
    return max(1, int(reach * 2.0 ** -source.uniform(1, 12))) * source.choice((-1, 1))


def _shift(corners: Corners, source: random.Random) -> Corners:
    """Move one corner."""
    i, axis = source.randrange(len(corners)), source.randrange(3)
    x, y = corners[i]
    moved = (x + (_step(corners, source) if axis != 1 else 0), y + (_step(corners, source) if axis != 0 else 0))
    return (*corners[:i], moved, *corners[i + 1 :])


def _align(corners: Corners, source: random.Random) -> Corners:
    """Give one corner a coordinate of another."""
    i, j = source.sample(range(len(corners)), 2)
    (x, y), (u, v) = corners[i], corners[j]
    return (*corners[:i], (u, y) if source.random() < 0.5 else (x, v), *corners[i + 1 :])


def _stretch(corners: Corners, source: random.Random) -> Corners:
    """Widen or narrow everything beyond a line parallel to an axis."""
    axis = source.randrange(2)
    beyond = source.choice(corners)[axis]
    span = max(corner[axis] for corner in corners) or 1
    by = source.choice((abs(_step(corners, source)), span, -abs(_step(corners, source))))
    return tuple((x + by, y) if axis == 0 and x >= beyond else (x, y + by) if axis == 1 and y >= beyond else (x, y)
                 for x, y in corners)


def _insert(corners: Corners, source: random.Random) -> Corners:
    """Put a corner near the middle of an edge."""
    if len(corners) >= MOST_CORNERS:
        return corners
    i = source.randrange(len(corners))
    (x, y), (u, v) = corners[i - 1], corners[i]
    new = ((x + u) // 2 + source.choice((0, _step(corners, source))),
           (y + v) // 2 + source.choice((0, _step(corners, source))))
    return (*corners[:i], new, *corners[i:])


def _drop(corners: Corners, source: random.Random) -> Corners:
    """Leave a corner out."""
    if len(corners) < 4:
        return corners
    i = source.randrange(len(corners))
    return corners[:i] + corners[i + 1 :]


def _refine(corners: Corners, source: random.Random) -> Corners:
    """Double all coordinates, so that moves get finer."""
    return tuple((2 * x, 2 * y) for x, y in corners)


_MOVES: tuple[Callable[[Corners, random.Random], Corners], ...] = (
    _shift, _shift, _shift, _align, _stretch, _stretch, _insert, _drop, _refine)
