"""The frame in which one-sided quadrilaterals are triangulated, and what a candidate is."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import repeat
from typing import Literal, NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.steps.heights import feature_squared, height_squared
from exactmesh.steps.records import Cycle, Piece

_ZERO = mpq(0)
_ONE = mpq(1)

# Which anchors have fans beside the gaps that get apexes; and the reaches of the fans in heights, in order of trial.
Mode = Literal["AB", "A", "B"]
MODES: tuple[Mode, ...] = ("AB", "A", "B")
REACHES = (2, 1, 3)
# The same in a frame along the clean side: two such fans do not meet over an edge of P.
BELOW_REACH = 1


# A face and the numbers of T-vertices on its three sides, the cycle starting at a corner.
Face = tuple[Cycle, tuple[int, int, int]]


class Trial(NamedTuple):
    """A triangulation in the frame, not measured yet: its faces counter-clockwise, and new points."""

    faces: list[Face]
    steiner: tuple[Point, ...]

    def candidate(self, frame: "Frame") -> "Candidate":
        """Return the triangulation with its value; when that is not positive, it is the value of some face."""
        return Candidate(self._value(frame.points()), self.cycles, self.steiner)

    @property
    def cycles(self) -> tuple[Cycle, ...]:
        """The faces."""
        return tuple(cycle for cycle, _ in self.faces)

    def _value(self, given: list[Point]) -> mpq:
        """Return the least signed squared feature size of the faces; stops at the first that is not positive."""
        least: mpq | None = None
        for cycle, counts in self.faces:
            points = [given[v] if v >= 0 else self.steiner[-1 - v] for v in cycle]
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


class Candidate(NamedTuple):
    """A triangulation in the frame: its signed squared feature size, faces counter-clockwise, new points."""

    value: mpq
    faces: tuple[Cycle, ...]
    steiner: tuple[Point, ...] = ()


@dataclass(frozen=True, slots=True)
class Frame:
    """A one-sided quadrilateral with u_j = (u[j], 0), u[0] = 0, and the anchors a, b above the T-side.

    Faces refer to u_j by j, to the anchors by `left` and `right`. The T-side, of length l, has length 1 in the frame:
    lengths are 1/l times the true ones, 1/l^2 = `scale_squared`, and the way back is without divisions.

    A crooked T-side, from left to right, has u_j = (u[j], rise[j]) in a frame that may have any origin and scale.
    """

    u: tuple[mpq, ...]
    a: Point
    b: Point
    origin: Point
    along: Point
    mirrored: bool
    rise: tuple[mpq, ...] = ()

    @property
    def scale_squared(self) -> mpq:
        """The square of the factor by which lengths in the frame are larger."""
        return 1 / dot(self.along, self.along)

    @property
    def left(self) -> int:
        """The index by which faces refer to the anchor a."""
        return len(self.u)

    @property
    def right(self) -> int:
        """The index by which faces refer to the anchor b."""
        return len(self.u) + 1

    def points(self) -> list[Point]:
        """Return the given points in the frame, by the index faces use."""
        return [*map(Point, self.u, self.rise or repeat(_ZERO)), self.a, self.b]

    def clean_height(self) -> mpq:
        """Return h0, the least height of the clean side over the part of the T-side below it; 0 if there is none."""
        a, b = self.a, self.b
        if a.x == b.x:
            return min(a.y, b.y)
        start, end = max(self.u[0], min(a.x, b.x)), min(self.u[-1], max(a.x, b.x))
        if start > end:
            return _ZERO
        slope = (b.y - a.y) / (b.x - a.x)
        return min(a.y + slope * (start - a.x), a.y + slope * (end - a.x))

    def along_clean_side(self) -> "Frame | None":
        """Return the frame whose x axis runs along the clean side, from 0 to 1, the crooked T-side below.

        The lower end of the T-side has height h over the clean side; there the T-side has height 0 and less, the
        anchors have height h. None where h <= 0, or where the T-side does not go from left to right.
        """
        if self.a == self.b:
            return None
        a, along = self.a, minus(self.b, self.a)
        length_squared = dot(along, along)
        to_side = [minus(u, a) for u in self.points()[:-2]]
        xs = tuple(dot(to, along) / length_squared for to in to_side)
        heights = [cross(to, along) / length_squared for to in to_side]
        low = min(heights[0], heights[-1])
        if low <= 0 or xs[0] >= xs[-1]:
            return None
        origin = Point(a.x + low * along.y, a.y - low * along.x)
        return Frame(xs, Point(_ZERO, low), Point(_ONE, low), origin, along, False, tuple(low - h for h in heights))

    def gaps_between_fans(self, mode: Mode, reach: int) -> range | None:
        """Return the gaps [u_j, u_j+1] left between the fans of the anchors; None when there are none.

        The fan of A takes the initial run of u with u <= x_A + reach * h_A, that of B the final one likewise; in mode
        "A" there is no fan of B, in mode "B" none of A.
        """
        start, end = 0, len(self.u) - 1
        if mode != "B":
            limit = self.a.x + reach * self.a.y
            while start < len(self.u) - 1 and self.u[start + 1] <= limit:
                start += 1
        if mode != "A":
            limit = self.b.x - reach * self.b.y
            while end > 0 and self.u[end - 1] >= limit:
                end -= 1
        return range(start, end) if start < end else None

    def fans(self, gaps: range) -> list[Cycle]:
        """Return the faces of the two fans beside the given gaps."""
        faces: list[Cycle] = [(j, j + 1, self.left) for j in range(gaps.start)]
        return faces + [(j, j + 1, self.right) for j in range(gaps.stop, len(self.u) - 1)]

    def piece(self, faces: Sequence[Cycle], steiner: Iterable[Point]) -> Piece:
        """Return a triangulation in the plane, counter-clockwise there."""
        o, d = self.origin, self.along
        nx, ny = (d.y, -d.x) if self.mirrored else (-d.y, d.x)
        places = tuple([Point(o.x + p.x * d.x + p.y * nx, o.y + p.x * d.y + p.y * ny) for p in steiner])
        return Piece(tuple(face[::-1] for face in faces) if self.mirrored else tuple(faces), places)


def frame_of(t_side: Sequence[Point], a: Point, b: Point) -> Frame:
    """Return the frame of the quadrilateral with the given T-side and anchors.

    It is mirrored when the quadrilateral u_0, u_m, b, a, by its signed area, lies on the right of the T-side; an
    anchor by itself may lie on the other side.
    """
    origin, end = t_side[0], t_side[-1]
    along = minus(end, origin)
    # Twice the area of the quadrilateral is the cross product of its diagonals.
    mirrored = cross(minus(b, origin), minus(a, end)) < 0
    length_squared = dot(along, along)
    right, up = along.x / length_squared, along.y / length_squared
    side = -1 if mirrored else 1

    def local(p: Point) -> Point:
        x, y = p.x - origin.x, p.y - origin.y
        return Point(x * right + y * up, side * (y * right - x * up))

    # On the T-side the share of the way is the same in either coordinate.
    inner = ([(p.y - origin.y) / along.y for p in t_side[1:-1]] if along.y else
             [(p.x - origin.x) / along.x for p in t_side[1:-1]])
    return Frame((_ZERO, *inner, _ONE), local(a), local(b), origin, along, mirrored)
