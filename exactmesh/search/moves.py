"""Local search by exact moves on figures with integer coordinates: hill climbing and annealing.

Whether a figure is planar and which of two is worse is decided exactly. Annealing may accept a better-behaved figure
at a chance computed in floats: that orders what is looked at next and decides nothing.
"""

import random
from collections.abc import Callable
from math import exp

from exactmesh.planar.pslg import Edge
from exactmesh.search.corners import Corner, Corners
from exactmesh.search.figure import Figure, is_planar, normal_form
from exactmesh.search.shrink import without
from exactmesh.search.targets import Evaluation

# Corners of polygons, and points of other figures, are not inserted beyond this: a mesh takes time linear in them.
MOST_CORNERS = 16
_MOST_POINTS = 30
_LARGEST = 1 << 24


def climb(start: Figure, see: Callable[[Figure], Evaluation], steps: int, source: random.Random, warmth: float = 0.0
          ) -> Figure:
    """Return the worst figure met on a walk of `steps` evaluations from `start`; warmth 0 is hill climbing."""
    here = best = normal_form(start)
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


def move(figure: Figure, source: random.Random, attempts: int = 20) -> Figure | None:
    """Return a planar figure one random move away, None when none is met. Polygons stay polygons."""
    moves = _OF_POLYGONS if figure.is_polygon else _OF_OTHERS
    for _ in range(attempts):
        there = normal_form(source.choice(moves)(figure, source))
        if (there != figure and there.points and max(abs(c) for place in there.places for c in place) <= _LARGEST
                and is_planar(there)):
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


_POLYGON_MOVES: tuple[Callable[[Corners, random.Random], Corners], ...] = (
    _shift, _shift, _shift, _align, _stretch, _stretch, _insert, _drop, _refine)


def _subdivide(figure: Figure, source: random.Random) -> Figure:
    """Put a point near the middle of an edge."""
    if not figure.edges or len(figure.points) >= _MOST_POINTS:
        return figure
    i = source.randrange(len(figure.edges))
    u, v = figure.edges[i]
    (x, y), (z, w) = figure.points[u], figure.points[v]
    new = ((x + z) // 2 + source.choice((0, _step(figure.points, source))),
           (y + w) // 2 + source.choice((0, _step(figure.points, source))))
    count = len(figure.points)
    return Figure((*figure.points, new), (*figure.edges[:i], (u, count), (count, v), *figure.edges[i + 1 :]),
                  figure.holes)


def _leave_out(figure: Figure, source: random.Random) -> Figure:
    """Leave a point out, with its edges; the ends of two are joined as often as not."""
    v = source.randrange(len(figure.points))
    ends = [u if w == v else w for u, w in figure.edges if v in (u, w)]
    edges: tuple[Edge, ...] = figure.edges
    if len(ends) == 2 and source.random() < 0.5:
        edges = (*edges, (ends[0], ends[1]))
    return without(Figure(figure.points, edges, figure.holes), {v})


def _join(figure: Figure, source: random.Random) -> Figure:
    """Join two points by an edge."""
    u, v = sorted(source.sample(range(len(figure.points)), 2))
    return figure if (u, v) in figure.edges else Figure(figure.points, (*figure.edges, (u, v)), figure.holes)


def _cut(figure: Figure, source: random.Random) -> Figure:
    """Take an edge away."""
    if not figure.edges:
        return figure
    i = source.randrange(len(figure.edges))
    return Figure(figure.points, figure.edges[:i] + figure.edges[i + 1 :], figure.holes)


def _add(figure: Figure, source: random.Random) -> Figure:
    """Put a point near another: on its own, or at the end of a slit."""
    if len(figure.points) >= _MOST_POINTS:
        return figure
    v = source.randrange(len(figure.points))
    slit: tuple[Edge, ...] = ((v, len(figure.points)),) if source.random() < 0.5 else ()
    return Figure((*figure.points, _near(figure.points[v], figure.points, source)), figure.edges + slit, figure.holes)


def _mark(figure: Figure, source: random.Random) -> Figure:
    """Take a hole point away, or put one near a point."""
    if figure.holes and source.random() < 0.5:
        i = source.randrange(len(figure.holes))
        return Figure(figure.points, figure.edges, figure.holes[:i] + figure.holes[i + 1 :])
    return Figure(figure.points, figure.edges,
                  (*figure.holes, _near(source.choice(figure.points), figure.points, source)))


def _near(place: Corner, points: Corners, source: random.Random) -> Corner:
    return place[0] + _step(points, source), place[1] + _step(points, source)


def _of_corners(change: Callable[[Corners, random.Random], Corners]) -> Callable[[Figure, random.Random], Figure]:
    return lambda polygon, source: Figure.polygon(change(polygon.points, source))


def _of_places(change: Callable[[Corners, random.Random], Corners]) -> Callable[[Figure, random.Random], Figure]:
    return lambda figure, source: figure.at(change(figure.places, source))


_OF_POLYGONS = tuple(map(_of_corners, _POLYGON_MOVES))
_OF_OTHERS = (*map(_of_places, (_shift, _shift, _shift, _align, _stretch, _stretch, _refine)),
              _subdivide, _leave_out, _join, _cut, _add, _mark)
