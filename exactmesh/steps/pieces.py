"""Triangulate many clean and one-sided quadrilaterals at once: floats choose where they can, else the exact rules do.

In      points with columns; the corners of clean quadrilaterals, as for `quad`; T-sides and anchors, as for
        `triangulate_one_sided`; all by the numbers of vertices.
Out     a `Piece` each, the very one that `quad` or `triangulate_one_sided` returns.
Exact   new vertices are rational, by the same rules. A candidate is measured in floats with error bounds; where they
        do not tell whether it reaches the wanted feature size, or which of two is better, the exact rules decide.
Raises  what `triangulate_one_sided` raises.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import chain
from typing import NamedTuple

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from exactmesh.geometry.balls import Balls, Bools, Floats, Ints, ball_of
from exactmesh.geometry.columns import Columns, indices
from exactmesh.geometry.decisions import note
from exactmesh.geometry.face_columns import CHUNK, chunks
from exactmesh.geometry.point import Point
from exactmesh.steps.constants import FEATURE_SQUARED
from exactmesh.steps.frame import Frame, Trial, frame_of
from exactmesh.steps.layers import layered_trials
from exactmesh.steps.nested import nested_trials
from exactmesh.steps.one_sided import ALL_SPLITS, fan_of, split_faces, triangulate_one_sided
from exactmesh.steps.quad import DIAGONALS, quad
from exactmesh.steps.records import Piece

# What floats say of a choice: none of the simple candidates is good enough, or they cannot tell.
_NONE, _OPEN = -1, -2
_DIAGONAL = tuple(map(Piece, DIAGONALS))
_CORNERS = np.array([[j for j in range(4) if j != i] for i in range(4)])
_TRIANGLE = tuple(Piece((tuple(corners),)) for corners in _CORNERS.tolist())
# So few quadrilaterals take less time by the exact rules than arrays do.
_FEW = 12
# Candidates that are measured at once.
_ROUND = 1 << 10


class OneSided(NamedTuple):
    """A quadrilateral with T-vertices on one side: the vertices of its T-side, and the anchors."""

    t_side: tuple[int, ...]
    a: int
    b: int


def triangulate_quads(points: Columns, corners: Sequence[Sequence[int]], wanted_squared: mpq = FEATURE_SQUARED
                      ) -> Iterator[Piece]:
    """Yield `quad` of each quadrilateral."""
    if len(corners) <= _FEW:
        note("quad", len(corners), len(corners))
        yield from (quad([points[v] for v in names], wanted_squared) for names in corners)
        return
    at = indices(chain.from_iterable(corners), 4 * len(corners)).reshape(-1, 4)
    choice = np.full(len(at), _OPEN)
    for start, part in chunks(at):
        choice[start : start + CHUNK] = _better_diagonals(points, part, _bounds(wanted_squared)[1])
    corner_of_triangle = _merged_corners(points, at)
    note("quad", len(at), int(((choice == _OPEN) & (corner_of_triangle == _OPEN)).sum()))
    for names, diagonal, merged in zip(corners, choice.tolist(), corner_of_triangle.tolist(), strict=True):
        if merged != _OPEN:
            yield _TRIANGLE[merged]
        elif diagonal != _OPEN:
            yield _DIAGONAL[diagonal]
        else:
            yield quad([points[v] for v in names], wanted_squared)


def _bounds(value: mpq) -> tuple[float, float]:
    """Return floats that enclose a value."""
    ball = ball_of(value)
    return float(ball.low()[0]), float(ball.high()[0])


def _better_diagonals(points: Columns, corners: Ints, wanted: float) -> Ints:
    """Return which diagonal of each quadrilateral is good enough and the better one, or that this is open."""
    least = []
    for faces in DIAGONALS:
        heights = [_signed_heights(points, *corners[:, face].T) for face in faces]
        least.append((np.minimum(heights[0].low(), heights[1].low()), np.minimum(heights[0].high(), heights[1].high())))
    (low, high), (other_low, other_high) = least
    choice = np.full(len(corners), _OPEN)
    choice[(low >= other_high) & (low >= wanted)] = 0
    choice[(other_low > high) & (other_low >= wanted)] = 1
    return choice


def _merged_corners(points: Columns, corners: Ints) -> Ints:
    """Return the corner that is the same vertex as the one before it, where the others are sure to be a triangle."""
    same = corners == corners[:, (3, 0, 1, 2)]
    found = np.full(len(corners), _OPEN)
    some = np.flatnonzero(same.sum(axis=1) == 1)
    merged = np.argmax(same[some], axis=1)
    a, b, c = np.take_along_axis(corners[some], _CORNERS[merged], axis=1).T
    sure = points.doubled_areas(a, b, c).signs() != 0
    found[some[sure]] = merged[sure]
    return found


def _signed_heights(points: Columns, a: Ints, b: Ints, c: Ints) -> Balls:
    """Return the signed squares of the least heights of triangles."""
    heights = points.heights_squared(a, b, c)
    turns_right = points.doubled_areas(a, b, c).mid < 0
    # A sign that is in doubt is that of a number within the error of 0.
    return Balls(np.where(turns_right, -heights.mid, heights.mid), heights.rad)


def triangulate_one_sided_ones(points: Columns, jobs: Sequence[OneSided], proper: bool = False,
                               wanted_squared: mpq = FEATURE_SQUARED) -> list[Piece]:
    """Return `triangulate_one_sided` of each quadrilateral."""
    if len(jobs) <= _FEW:
        note("one-sided", len(jobs), len(jobs))
        return [_exactly(points, job, proper, wanted_squared) for job in jobs]
    found: list[Piece | None] = [None] * len(jobs)
    by_gaps: dict[int, list[int]] = defaultdict(list)
    fans = []
    for number, job in enumerate(jobs):
        if job.a == job.b:
            fans.append(number)
        else:
            by_gaps[len(job.t_side) - 1].append(number)
    is_left = points.turns(indices(jobs[i].t_side[0] for i in fans), indices(jobs[i].t_side[-1] for i in fans),
                           indices(jobs[i].a for i in fans)) > 0
    for number, left in zip(fans, is_left.tolist(), strict=True):
        found[number] = fan_of(len(jobs[number].t_side) - 1, left)
    low = []
    for gaps, numbers in by_gaps.items():
        rows = max(1, CHUNK // (gaps + 1))
        for start in range(0, len(numbers), rows):
            some = numbers[start : start + rows]
            choice, mirrored = _splits(points, [jobs[i] for i in some], gaps, wanted_squared)
            for number, i, is_mirrored in zip(some, choice.tolist(), mirrored.tolist(), strict=True):
                if i >= 0:
                    found[number] = _split_piece(gaps, i, is_mirrored)
                elif i == _NONE:
                    low.append(number)
    _Rounds(points, jobs, sorted(low), proper, wanted_squared, found).run()
    left_open = [number for number, piece in enumerate(found) if piece is None]
    for number in left_open:
        found[number] = _exactly(points, jobs[number], proper, wanted_squared)
    note("one-sided", len(jobs), len(left_open))
    return [piece for piece in found if piece is not None]


def _exactly(points: Columns, job: OneSided, proper: bool, wanted_squared: mpq) -> Piece:
    return triangulate_one_sided([points[v] for v in job.t_side], points[job.a], points[job.b], proper, wanted_squared)


@cache
def _split_piece(gaps: int, i: int, mirrored: bool) -> Piece:
    faces = split_faces(gaps, i)
    return Piece(tuple(face[::-1] for face in faces) if mirrored else faces)


def _splits(points: Columns, jobs: Sequence[OneSided], gaps: int, wanted_squared: mpq) -> tuple[Ints, Bools]:
    """Return the first split of each quadrilateral that is good enough, and whether they are mirrored."""
    wanted_low, wanted_high = _bounds(wanted_squared)
    count = len(jobs)
    u = indices(chain.from_iterable(job.t_side for job in jobs), count * (gaps + 1)).reshape(count, -1)
    a, b = indices((job.a for job in jobs), count), indices((job.b for job in jobs), count)
    side = points.vectors(u[:, 0], b).cross(points.vectors(u[:, -1], a)).signs()

    def heights(p: Ints, q: Ints, r: Ints) -> tuple[Floats, Floats]:
        """Return bounds of the heights as seen in the frame, a row a quadrilateral."""
        found = _signed_heights(points, *(v.ravel() for v in np.broadcast_arrays(p, q, r)))
        found = Balls(found.mid * np.repeat(side, len(found) // count), found.rad)
        return found.low().reshape(count, -1), found.high().reshape(count, -1)

    of_a, of_b = (heights(u[:, :-1], u[:, 1:], anchor[:, None]) for anchor in (a, b))
    at_split = heights(a[:, None], u, b[:, None])
    for bound, left, right in zip(at_split, of_a, of_b, strict=True):
        bound[:, 1:] = np.minimum(bound[:, 1:], np.minimum.accumulate(left, axis=1))
        bound[:, :-1] = np.minimum(bound[:, :-1], np.minimum.accumulate(right[:, ::-1], axis=1)[:, ::-1])
    low, high = at_split
    too_low = high < wanted_low
    first = np.argmin(too_low, axis=1)
    good = low[np.arange(count), first] >= wanted_high
    # Of many splits the exact rule tries a few only.
    choice = np.where(too_low.all(axis=1), _NONE, np.where(good & (gaps <= ALL_SPLITS), first, _OPEN))
    return np.where(side == 0, _OPEN, choice), side < 0


class _Rounds:
    """Tries candidates beyond splits, in each round the next one of every quadrilateral that has none yet."""

    def __init__(self, points: Columns, jobs: Sequence[OneSided], numbers: Sequence[int], proper: bool,
                 wanted_squared: mpq, found: list[Piece | None]) -> None:
        self.found, self.wanted_squared = found, wanted_squared
        frames = [frame_of([points[v] for v in jobs[i].t_side], points[jobs[i].a], points[jobs[i].b]) for i in numbers]
        trials = layered_trials if proper else nested_trials
        self.pending = [(i, frame, trials(frame)) for i, frame in zip(numbers, frames, strict=True)]

    def run(self) -> None:
        """Fill in what is found; where no candidate is good enough, or where none is left, nothing."""
        while self.pending:
            tried = [(number, frame, rest, trial) for number, frame, rest in self.pending
                     if (trial := next(rest, None)) is not None]
            self.pending = []
            for start in range(0, len(tried), _ROUND):
                some = tried[start : start + _ROUND]
                good = _are_good([(frame, trial) for _, frame, _, trial in some], self.wanted_squared)
                for (number, frame, rest, trial), sure in zip(some, good.tolist(), strict=True):
                    if sure > 0 or (sure == 0 and self._is_good(frame, trial)):
                        self.found[number] = frame.piece(trial.cycles, trial.steiner)
                    else:
                        self.pending.append((number, frame, rest))

    def _is_good(self, frame: Frame, trial: Trial) -> bool:
        return bool(trial.candidate(frame).value >= self.wanted_squared * frame.scale_squared)


def _are_good(tried: Sequence[tuple[Frame, Trial]], wanted_squared: mpq) -> NDArray[np.int8]:
    """Return 1 where a trial keeps the wanted feature size, -1 where it does not, 0 where that is not decided."""
    places: list[Point] = []
    triangles: list[tuple[int, int, int]] = []
    begin = []
    t_vertices: list[tuple[int, int, int, int]] = []
    for number, (frame, trial) in enumerate(tried):
        # Given points, then new ones from the last to the first, so that -1 - i counts from the end.
        start = len(places)
        places += [*frame.points(), *reversed(trial.steiner)]
        names = range(start, len(places))
        begin.append(len(triangles))
        for cycle, counts in trial.faces:
            first, second = 1 + counts[0], 2 + counts[0] + counts[1]
            corners = names[cycle[0]], names[cycle[first]], names[cycle[second]]
            triangles.append(corners)
            if len(cycle) > 3:
                for side, some in enumerate((cycle[1:first], cycle[first + 1 : second], cycle[second + 1 :])):
                    p, q, r = corners[side], corners[side - 2], corners[side - 1]
                    for t in some:
                        t_vertices += [(number, names[t], q, r), (number, names[t], r, p)]
    points = Columns(places)
    wanted = ball_of(*(wanted_squared * frame.scale_squared for frame, _ in tried))
    a, b, c = indices(chain.from_iterable(triangles), 3 * len(triangles)).reshape(-1, 3).T
    heights = _signed_heights(points, a, b, c)
    low, high = np.minimum.reduceat(heights.low(), begin), np.minimum.reduceat(heights.high(), begin)
    if t_vertices:
        at, a, b, c = indices(chain.from_iterable(t_vertices), 4 * len(t_vertices)).reshape(-1, 4).T
        distances = points.segment_distances_squared(a, b, c)
        np.minimum.at(low, at, distances.low())
        np.minimum.at(high, at, distances.high())
    good: NDArray[np.int8] = (low >= wanted.high()).astype(np.int8) - (high < wanted.low()).astype(np.int8)
    return good
