"""The nested triangulation of a one-sided quadrilateral: Lemma 3 for any gaps, one new vertex a gap.

Each gap [u_j, u_j+1] between the fans of the anchors gets one apex low above it. The apexes left of a middle one, z,
are grouped: a group has a leader E, and its members, which stand at least half as far from A as E, lie on the
segment A E. So the long triangles at A have walls in a ratio of 2 or more and carry T-vertices on one side only. The
same on the right with B.

A member half as far out as E, below a leader twice as far, is a fifth of the height from the line of the latter
measured upwards, so a hair nearer to it. The last candidate begins a new group there instead, whose ratio is a hair
below 2.

Long faces carry T-vertices, listed in the cycle of the face.
"""

from bisect import bisect_left
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.frame import BELOW_REACH, MODES, REACHES, Candidate, Face, Frame, Mode, Trial

_ZERO = mpq(0)
_HEIGHTS = (mpq(1, 5), mpq(23, 100))
_HEIGHTS_FEW_GAPS = (mpq(1, 5), mpq(1, 4), mpq(1, 3), mpq(2, 5))
# Of a height, below a clean side that slants: how deep leaders stand under the T-side, and the greatest inset.
_DEPTH = mpq(1, 5)
_BELOW_INSET = mpq(1, 2)


def nested_candidates(frame: Frame) -> Iterator[Candidate]:
    """Yield those nested triangulations that are triangulations, in the order in which they are tried."""
    for trial in nested_trials(frame):
        candidate = trial.candidate(frame)
        if candidate.value > 0:
            yield candidate


def nested_trials(frame: Frame) -> Iterator[Trial]:
    """Yield the nested triangulations in the order in which they are tried; none when the clean side is too low."""
    h0 = frame.clean_height()
    if h0 <= 0:
        return
    heights = _HEIGHTS_FEW_GAPS if len(frame.u) <= 4 else _HEIGHTS
    for mode in MODES:
        for beta in heights:
            for reach in REACHES:
                if (trial := _nested(frame, h0, mode, beta * h0, reach)) is not None:
                    yield trial
    height = heights[0] * h0
    if (trial := _nested(frame, h0, MODES[0], height, REACHES[0], height)) is not None:
        yield trial


def nested_below(frame: Frame) -> Candidate | None:
    """Return the nested triangulation that is laid out along the clean side, None where it has no place.

    So the long triangles are those of a strip, however much the T-side slants, and wherever the anchors are. A leader
    keeps a fifth of the height from the line of the T-side, for 1 + s^2/2 is above the root of 1 + s^2, s the slope.
    """
    along = frame.along_clean_side()
    gaps = along.gaps_between_fans(MODES[0], BELOW_REACH) if along is not None else None
    if along is None or gaps is None:
        return None
    h0, xs, rise = along.a.y, along.u, along.rise
    u = xs[gaps.start : gaps.stop + 1]
    insets = [min((v - w) / 2, _BELOW_INSET * h0) for w, v in pairwise(u)]
    z, z_x = _middle(u, insets, mpq(1, 2))
    slope = (rise[-1] - rise[0]) / (xs[-1] - xs[0])
    found = _over(along, _Layout(gaps.start, gaps.stop, z, _abscissae(u, insets, z, z_x)), along.a, along.b,
                  _DEPTH * h0 * (1 + slope**2 / 2), _DEPTH * h0)
    return None if found is None else Trial(found.faces, along.piece((), found.steiner).steiner).candidate(frame)


class _Layout(NamedTuple):
    """Apex j - `start` stands over gap j; `z` is the place of the middle apex among the apexes."""

    start: int
    end: int
    z: int
    x: list[mpq]


def _nested(frame: Frame, h0: mpq, mode: Mode, height: mpq, reach: int, apart: mpq = _ZERO) -> Trial | None:
    layout = _layout(frame, h0, mode, reach)
    return None if layout is None else _over(frame, layout, frame.a, frame.b, height, apart)


def _over(frame: Frame, layout: _Layout, a: Point, b: Point, height: mpq, apart: mpq = _ZERO) -> Trial | None:
    """Return the triangulation with leaders at a height, in the coordinates of the layout, a and b."""
    z, xs = layout.z, layout.x
    to_left = _groups(xs[z::-1], a, height, apart)
    # The right side is the left one seen in a mirror.
    to_right = _groups([-x for x in xs[z:]], Point(-b.x, b.y), height, apart)
    if to_left is None or to_right is None:
        return None
    heights = [y for _, y in reversed(to_left)] + [y for _, y in to_right[1:]]
    return Trial(_faces(frame, layout, [g for g, _ in to_left], [g for g, _ in to_right]),
                 tuple(map(Point, xs, heights)))


def _layout(frame: Frame, h0: mpq, mode: Mode, reach: int) -> _Layout | None:
    """Return where the apexes stand; None when the fans of the anchors leave no gap.

    Apex j may stand anywhere between u_j and u_j+1 that is `inset` from both.
    """
    gaps = frame.gaps_between_fans(mode, reach)
    if gaps is None:
        return None
    start, end = gaps.start, gaps.stop
    u = frame.u[start : end + 1]
    insets = [min((v - w) / 2, h0) for w, v in pairwise(u)]
    if mode == "A":
        z, z_x = end - start - 1, u[-1] - insets[-1]
    elif mode == "B":
        z, z_x = 0, u[0] + insets[0]
    else:
        z, z_x = _middle(u, insets, (frame.a.x + frame.b.x) / 2)
    return _Layout(start, end, z, _abscissae(u, insets, z, z_x))


def _abscissae(u: tuple[mpq, ...], insets: list[mpq], z: int, z_x: mpq) -> list[mpq]:
    """Return the abscissae of all apexes: those beside the middle one stand as near to it as they can."""
    return [*(u[j + 1] - insets[j] for j in range(z)), z_x, *(u[j] + insets[j] for j in range(z + 1, len(insets)))]


def _middle(u: tuple[mpq, ...], insets: list[mpq], middle: mpq) -> tuple[int, mpq]:
    """Return which apex can come nearest to the given abscissa, the first on a tie, and its abscissa then."""
    last = len(insets) - 1
    # The first apex that can reach the middle or what is right of it: distances fall before it and rise from it on.
    z = min(bisect_left(u, middle, 1) - 1, last)
    while z < last and u[z + 1] - insets[z] < middle:
        z += 1
    nearest = min(max(middle, u[z] + insets[z]), u[z + 1] - insets[z])
    if z > 0:
        before = u[z] - insets[z - 1]
        if middle - before <= abs(nearest - middle):
            return z - 1, before
    return z, nearest


def _groups(xs: list[mpq], anchor: Point, height: mpq, apart: mpq) -> list[tuple[int, mpq]] | None:
    """Return the group number and the height of each apex, from z outwards to the anchor on the left.

    A member keeps the given distance from the line of the group before. None when a leader does not stand right of the
    anchor although there are apexes left of z.
    """
    found: list[tuple[int, mpq]] = []
    group = -1
    left, low = anchor
    nearest = slope = left
    before = _ZERO
    for x in xs:
        if group >= 0 and x >= nearest and (not group or not apart or _keeps(x - left, slope, before, apart)):
            found.append((group, low + (x - left) * slope))
            continue
        group += 1
        found.append((group, height))
        if len(xs) > 1:
            if x <= left:
                return None
            # Members stand at least half as far from the anchor, on the segment to the leader.
            nearest, before, slope = (x + left) / 2, slope, (height - low) / (x - left)
    return found


def _keeps(x: mpq, slope: mpq, other: mpq, apart: mpq) -> bool:
    """Return whether the point at x of a line through the origin keeps a distance from another one, by their slopes."""
    return bool((x * (slope - other)) ** 2 >= apart * apart * (1 + other * other))


def _faces(frame: Frame, layout: _Layout, left_groups: list[int], right_groups: list[int]) -> list[Face]:
    """Return the faces; apex i is -1 - i."""
    start, end, z, xs = layout
    a, b, last = frame.left, frame.right, len(xs) - 1
    plain = (0, 0, 0)
    faces: list[Face] = [(fan, plain) for fan in frame.fans(range(start, end))]
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
