"""Triangulate a quadrilateral with T-vertices on one side only (in place of Lemma 3), for the interior and the Tube.

In      anchors A, B and the T-side u_0, .., u_m, collinear and in order, A next to u_0. The sides A B, A u_0 and
        B u_m are clean and stay so. A = B is allowed: then the fan of A is the only triangulation.
Out     `Piece` in which faces refer to u_j by j, to A by m + 1 and to B by m + 2.
Exact   the quadrilateral is brought into a frame whose x axis runs along the T-side, scaled by its length l: a point
        q has the coordinates (q - u_0).d and +-(d x (q - u_0)), d = u_m - u_0. Every rule is homogeneous of degree
        one, so all is rational, squared lengths are l^2 times the true ones, and no root is taken.
Raises  `ConstructionFailed` when no candidate is a triangulation.
Paper   Lemma 3 treats a rectangle with evenly spaced positions; its count of new vertices grows with the length. Here
        there is one new vertex a gap at most, for any gaps and for slanted sides.
Check   `patch_check.py`
"""

from collections.abc import Iterator, Sequence

from gmpy2 import mpq

from exactmesh.errors import ConstructionFailed
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.constants import FEATURE_SQUARED
from exactmesh.steps.frame import Candidate, Frame, frame_of
from exactmesh.steps.heights import height_squared
from exactmesh.steps.layers import layered_below, layered_candidates
from exactmesh.steps.nested import nested_below, nested_candidates
from exactmesh.steps.quad import centre_value, centres
from exactmesh.steps.records import Cycle, Piece

# With more T-vertices only the splits near the ends, the anchors and the middle between the anchors are tried.
ALL_SPLITS = 12
_SPLITS_AT_ENDS = 5
_HUB_GAPS = range(2, 9)
_HUB_PLACES = (mpq(1, 2), mpq(3, 10), mpq(7, 10))
_HUB_HEIGHTS = (mpq(7, 10), mpq(1, 2), mpq(4, 5))
_A_LITTLE_BELOW = mpq(4, 5)


def triangulate_one_sided(t_side: Sequence[Point], a: Point, b: Point, proper: bool = False,
                          wanted_squared: mpq = FEATURE_SQUARED) -> Piece:
    """Return the first triangulation that reaches the feature size wanted, else the best one there is.

    A `proper` one has no T-vertices: layers take the place of nested triangles.
    """
    if a == b:
        return fan_of(len(t_side) - 1, doubled_area(t_side[0], t_side[-1], a) > 0)
    frame = frame_of(t_side, a, b)
    wanted = wanted_squared * frame.scale_squared
    best: Candidate | None = None
    for candidate in _candidates(frame, proper):
        if candidate.value > 0 and (best is None or candidate.value > best.value):
            best = candidate
            if best.value >= wanted:
                break
    if best is None:
        raise ConstructionFailed("one-sided quadrilateral", {"t_side": tuple(t_side), "a": a, "b": b})
    return frame.piece(best.faces, best.steiner)


def fan_of(gaps: int, is_left: bool) -> Piece:
    """Return the fan of a single anchor, on the left of the T-side or not; it is counter-clockwise in the plane."""
    apex = gaps + 1
    return Piece(tuple((j, j + 1, apex) if is_left else (j + 1, j, apex) for j in range(gaps)))


def split_faces(gaps: int, i: int) -> tuple[Cycle, ...]:
    """Return the fan of A up to u_i, the fan of B from u_i on, and the triangle A u_i B."""
    left, right = gaps + 1, gaps + 2
    return (*((j, j + 1, left if j < i else right) for j in range(gaps)), (left, i, right))


def _candidates(frame: Frame, proper: bool) -> Iterator[Candidate]:
    """Yield split, nested or layered, then for one gap centres and for a few gaps hubs, then what the proof rests on
    where none is good enough: nested or layered along the clean side."""
    yield from _splits(frame)
    yield from layered_candidates(frame) if proper else nested_candidates(frame)
    m = len(frame.u) - 1
    if m == 1:
        yield from _centred(frame)
    elif m in _HUB_GAPS:
        yield from _hubs(frame)
    if m > 1 and not proper:
        yield _hub_between_fans(frame)
    if (below := layered_below(frame) if proper else nested_below(frame)) is not None:
        yield below


def _splits(frame: Frame) -> Iterator[Candidate]:
    """Yield the splits at some or all u_i."""
    points = frame.points()
    us, a, b = points[:-2], frame.a, frame.b
    m = len(us) - 1
    tried = range(m + 1) if m <= ALL_SPLITS else _split_places(frame)
    of_a = [height_squared(us[j], us[j + 1], a) for j in range(m)]
    of_b = [height_squared(us[j], us[j + 1], b) for j in range(m)]
    up_to, from_on = _running_least(of_a), _running_least(of_b[::-1])[::-1]
    for i in tried:
        value = height_squared(a, us[i], b)
        if i > 0:
            value = min(value, up_to[i - 1])
        if i < m:
            value = min(value, from_on[i])
        yield Candidate(value, split_faces(m, i))


def _split_places(frame: Frame) -> list[int]:
    m = len(frame.u) - 1
    places = {*range(_SPLITS_AT_ENDS), *range(m + 1 - _SPLITS_AT_ENDS, m + 1)}
    for x in (frame.a.x, frame.b.x, (frame.a.x + frame.b.x) / 2):
        places.add(min(range(m + 1), key=lambda i: abs(frame.u[i] - x)))
    return sorted(places)


def _running_least(values: list[mpq]) -> list[mpq]:
    least: list[mpq] = []
    for value in values:
        least.append(min(least[-1], value) if least else value)
    return least


def _outline(frame: Frame) -> tuple[list[int], list[Point]]:
    """Return the boundary u_0, .., u_m, B, A counter-clockwise, as indices and as points."""
    indices = [*range(len(frame.u)), frame.right, frame.left]
    points = frame.points()
    return indices, [points[i] for i in indices]


def _centred(frame: Frame) -> Iterator[Candidate]:
    indices, points = _outline(frame)
    for centre in centres(points):
        yield _star(indices, points, centre)
    # Half way across from the middle of the T-side, at a right angle to it: better where that is short and slants.
    a, b, middle = frame.a, frame.b, frame.u[1] / 2
    if a.x != b.x:
        above = a.y + (b.y - a.y) * (middle - a.x) / (b.x - a.x)
        yield _star(indices, points, Point(middle, above / 2))


def _hubs(frame: Frame) -> Iterator[Candidate]:
    indices, points = _outline(frame)
    a, b = frame.a, frame.b
    for height in _HUB_HEIGHTS:
        for place in _HUB_PLACES:
            hub = Point(a.x + place * (b.x - a.x), height * (a.y + place * (b.y - a.y)))
            yield _star(indices, points, hub)


def _hub_between_fans(frame: Frame) -> Candidate:
    """Return a hub a little below the middle of A B, the outermost triangles left to the anchors if far out.

    Where the anchors are very near to each other, and all T-vertices far out, no split is good.
    """
    a, b, m = frame.a, frame.b, len(frame.u) - 1
    gaps = range(frame.u[1] < a.x, m - (frame.u[m - 1] > b.x))
    points = frame.points()
    indices = [*range(gaps.start, gaps.stop + 1), frame.right, frame.left]
    star = _star(indices, [points[i] for i in indices], Point((a.x + b.x) / 2, _A_LITTLE_BELOW * (a.y + b.y) / 2))
    fans = tuple(frame.fans(gaps))
    value = min([star.value, *(height_squared(*(points[i] for i in face)) for face in fans)])
    return Candidate(value, fans + star.faces, star.steiner)


def _star(indices: list[int], points: list[Point], centre: Point) -> Candidate:
    """Return the candidate that joins one new vertex to the whole outline."""
    faces = tuple((indices[i - 1], indices[i], -1) for i in range(len(indices)))
    return Candidate(centre_value(points, centre), faces, (centre,))
