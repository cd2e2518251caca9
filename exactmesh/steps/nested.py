"""The nested triangulation of a one-sided quadrilateral: Lemma 3 for any gaps, one new vertex a gap.

Each gap [u_j, u_j+1] between the fans of the anchors gets one apex low above it. The apexes left of a middle one, z,
are grouped: a group has a leader E, and its members, which stand at least half as far from A as E, lie on the
segment A E. So the long triangles at A have walls in a ratio of 2 or more and carry T-vertices on one side only. The
same on the right with B.

A candidate is measured over all its faces; long ones carry T-vertices, listed in the cycle of the face.
"""

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.frame import MODES, REACHES, Candidate, Frame, Mode
from exactmesh.steps.heights import feature_squared, height_squared
from exactmesh.steps.records import Cycle

_HEIGHTS = (mpq(1, 5), mpq(23, 100))
_HEIGHTS_FEW_GAPS = (mpq(1, 5), mpq(1, 4), mpq(1, 3), mpq(2, 5))


def nested_candidates(frame: Frame) -> Iterator[Candidate]:
    """Yield the nested triangulations in the order in which they are tried; none when the clean side is too low."""
    h0 = frame.clean_height()
    if h0 <= 0:
        return
    heights = _HEIGHTS_FEW_GAPS if len(frame.u) <= 4 else _HEIGHTS
    for mode in MODES:
        for beta in heights:
            for reach in REACHES:
                if (candidate := _nested(frame, h0, mode, beta * h0, reach)) is not None:
                    yield candidate


class _Layout(NamedTuple):
    """Apex j - `start` stands over gap j; `z` is the place of the middle apex among the apexes."""

    start: int
    end: int
    z: int
    x: list[mpq]


def _nested(frame: Frame, h0: mpq, mode: Mode, height: mpq, reach: int) -> Candidate | None:
    layout = _layout(frame, h0, mode, reach)
    if layout is None:
        return None
    z, xs = layout.z, layout.x
    a, b = frame.a, frame.b
    to_left = _groups([xs[i] for i in range(z, -1, -1)], a, height)
    # The right side is the left one seen in a mirror.
    to_right = _groups([-xs[i] for i in range(z, len(xs))], Point(-b.x, b.y), height)
    if to_left is None or to_right is None:
        return None
    heights = [y for _, y in reversed(to_left)] + [y for _, y in to_right[1:]]
    steiner = tuple(map(Point, xs, heights))
    faces = _faces(frame, layout, [g for g, _ in to_left], [g for g, _ in to_right])
    value = _value(frame.points(), steiner, faces)
    return None if value <= 0 else Candidate(value, tuple(face for face, _ in faces), steiner)


def _layout(frame: Frame, h0: mpq, mode: Mode, reach: int) -> _Layout | None:
    """Return where the apexes stand; None when the fans of the anchors leave no gap."""
    u, a, b = frame.u, frame.a, frame.b
    gaps = frame.gaps_between_fans(mode, reach)
    if gaps is None:
        return None
    start, end = gaps.start, gaps.stop
    insets = [min((u[j + 1] - u[j]) / 2, h0) for j in range(start, end)]
    lows = [u[j] + insets[j - start] for j in range(start, end)]
    highs = [u[j + 1] - insets[j - start] for j in range(start, end)]
    if mode == "AB":
        middle = (a.x + b.x) / 2
        nearest = [min(max(middle, low), high) for low, high in zip(lows, highs, strict=True)]
        z = min(range(len(nearest)), key=lambda i: abs(nearest[i] - middle))
        z_x = nearest[z]
    else:
        z = end - start - 1 if mode == "A" else 0
        z_x = highs[z] if mode == "A" else lows[z]
    return _Layout(start, end, z, [*highs[:z], z_x, *lows[z + 1 :]])


def _groups(xs: list[mpq], anchor: Point, height: mpq) -> list[tuple[int, mpq]] | None:
    """Return the group number and the height of each apex, from z outwards to the anchor on the left.

    None when a leader does not stand right of the anchor although there are apexes left of z.
    """
    found: list[tuple[int, mpq]] = []
    group = -1
    leader = anchor.x
    for x in xs:
        if group >= 0 and 2 * (x - anchor.x) >= leader - anchor.x:
            found.append((group, anchor.y + (x - anchor.x) / (leader - anchor.x) * (height - anchor.y)))
            continue
        group, leader = group + 1, x
        found.append((group, height))
        if leader <= anchor.x and len(xs) > 1:
            return None
    return found


# A face and the numbers of T-vertices on its three sides, the cycle starting at a corner.
_Face = tuple[Cycle, tuple[int, int, int]]


def _faces(frame: Frame, layout: _Layout, left_groups: list[int], right_groups: list[int]) -> list[_Face]:
    """Return the faces; apex i is -1 - i."""
    start, end, z, xs = layout
    a, b, last = frame.left, frame.right, len(xs) - 1
    plain = (0, 0, 0)
    faces: list[_Face] = [(fan, plain) for fan in frame.fans(range(start, end))]
    for i in range(len(xs)):
        faces.append(((start + i, start + i + 1, -1 - i), plain))
        if i < last:
            faces.append(((-1 - i, start + i + 1, -2 - i), plain))
    faces += [((a, start, -1), plain), ((end, b, -1 - last), plain)]
    # Groups as runs of apexes, from z outwards; the first of a run is the leader.
    left = _runs([-1 - (z - i) for i in range(len(left_groups))], left_groups)
    right = _runs([-1 - (z + i) for i in range(len(right_groups))], right_groups)
    for nearer, further in pairwise(left):
        # The side from A to the leader of the further group carries the other members of that group.
        faces.append(((a, *reversed(further[1:]), further[0], nearer[-1]), (len(further) - 1, 0, 0)))
    for nearer, further in pairwise(right):
        faces.append(((further[0], *further[1:], b, nearer[-1]), (len(further) - 1, 0, 0)))
    faces.append(((a, *reversed(left[0][1:]), -1 - z, *right[0][1:], b), (len(left[0]) - 1, len(right[0]) - 1, 0)))
    return faces


def _runs(apexes: list[int], groups: list[int]) -> list[list[int]]:
    runs: list[list[int]] = [[] for _ in range(groups[-1] + 1)]
    for apex, group in zip(apexes, groups, strict=True):
        runs[group].append(apex)
    return runs


def _value(given: list[Point], steiner: tuple[Point, ...], faces: list[_Face]) -> mpq:
    """Return the least signed squared feature size of the faces; stops at the first that is not positive."""
    least: mpq | None = None
    for cycle, counts in faces:
        points = [given[v] if v >= 0 else steiner[-1 - v] for v in cycle]
        if len(points) == 3:
            value = height_squared(*points)
        else:
            first, second = 1 + counts[0], 2 + counts[0] + counts[1]
            corners = (points[0], points[first], points[second])
            value = feature_squared(corners, (points[1:first], points[first + 1 : second], points[second + 1 :]))
        if value <= 0:
            return value
        least = value if least is None else min(least, value)
    return least
