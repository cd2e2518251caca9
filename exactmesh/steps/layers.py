"""The layered triangulation of a one-sided quadrilateral: proper, at the price of a logarithm (for Theorem 2).

Each gap [u_j, u_j+1] between the fans of the anchors gets one apex in the lowest row; each row has one vertex for
every two of the row below, until one is left. Rows are evenly spaced below the clean side. No face has a T-vertex, and
there are at most 2 N + log2 N new vertices for N gaps (a row of odd length rounds up).

Rows are parallel to the T-side, or in the last candidate, where the two sides are not parallel, to the clean side.
"""

from collections.abc import Iterator
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.frame import BELOW_REACH, MODES, REACHES, Candidate, Frame, Trial
from exactmesh.steps.heights import height_squared
from exactmesh.steps.records import Cycle


def layered_candidates(frame: Frame) -> Iterator[Candidate]:
    """Yield the layered triangulations in the order in which they are tried."""
    for trial in layered_trials(frame):
        yield trial.candidate(frame)


def layered_trials(frame: Frame) -> Iterator[Trial]:
    """Yield the layered triangulations in the order in which they are tried; none when the clean side is too low."""
    h0 = frame.clean_height()
    if h0 <= 0:
        return
    for mode in MODES:
        for reach in REACHES:
            gaps = frame.gaps_between_fans(mode, reach)
            if gaps is not None:
                yield _Layers(frame, gaps, h0).trial()


def layered_below(frame: Frame) -> Candidate | None:
    """Return the layered triangulation with rows parallel to the clean side, None where it has no place.

    So the triangles between rows are those of a strip, however much the T-side slants, and wherever the anchors are.
    """
    along = frame.along_clean_side()
    gaps = along.gaps_between_fans(MODES[0], BELOW_REACH) if along is not None else None
    if along is None or gaps is None:
        return None
    trial = _Layers(along, gaps, along.a.y).trial()
    return Trial(trial.faces, along.piece((), trial.steiner).steiner).candidate(frame)


class _Layers:
    """Rows of vertices as they grow; a new vertex i is -1 - i."""

    def __init__(self, frame: Frame, gaps: range, h0: mpq) -> None:
        self.frame = frame
        self.gaps = gaps
        # ceil(log2 N) + 1 rows.
        self.rows = 1 + (len(gaps) - 1).bit_length()
        self.spacing = h0 / (self.rows + 1)
        self.middle = (frame.a.x + frame.b.x) / 2
        self.given = frame.points()
        self.steiner: list[Point] = []
        self.faces: list[Cycle] = frame.fans(gaps)

    def trial(self) -> Trial:
        """Return the triangulation."""
        frame, gaps, faces = self.frame, self.gaps, self.faces
        row = [self._between(frame.u[j], frame.u[j + 1], 1) for j in gaps]
        faces += [(j, j + 1, apex) for j, apex in zip(gaps, row, strict=True)]
        faces += [(a, j, b) for j, (a, b) in zip(gaps[1:], pairwise(row), strict=True)]
        faces += [(frame.left, gaps.start, row[0]), (gaps.stop, frame.right, row[-1])]
        for height in range(2, self.rows + 1):
            row = self._next(row, height)
        faces.append((frame.left, row[0], frame.right))
        return Trial([(face, (0, 0, 0)) for face in faces], tuple(self.steiner))

    def _point(self, v: int) -> Point:
        return self.given[v] if v >= 0 else self.steiner[-1 - v]

    def _between(self, low: mpq, high: mpq, height: int) -> int:
        """Return a new vertex in a row, as near to the middle of the clean side as its neighbours below allow."""
        inset = min((high - low) / 2, self.spacing)
        self.steiner.append(Point(min(max(self.middle, low + inset), high - inset), height * self.spacing))
        return -len(self.steiner)

    def _next(self, row: list[int], height: int) -> list[int]:
        """Add the row above `row` and the faces between the two."""
        frame, faces = self.frame, self.faces
        above: list[int] = []
        for i in range(0, len(row), 2):
            pair = row[i : i + 2]
            # A last vertex without a partner goes straight up.
            parent = self._between(self._point(pair[0]).x, self._point(pair[-1]).x, height)
            if len(pair) == 2:
                faces.append((pair[0], pair[1], parent))
            if above:
                self._add_quad(row[i - 1], pair[0], parent, above[-1])
            above.append(parent)
        faces += [(frame.left, row[0], above[0]), (row[-1], frame.right, above[-1])]
        return above

    def _add_quad(self, a: int, b: int, c: int, d: int) -> None:
        """Add the better of the two diagonals."""
        pairs = (((a, b, c), (a, c, d)), ((a, b, d), (b, c, d)))
        self.faces += max(pairs, key=lambda pair: min(height_squared(*map(self._point, face)) for face in pair))
