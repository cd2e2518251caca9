"""The frame in which one-sided quadrilaterals are triangulated, and what a candidate is."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.steps.records import Cycle, Piece

_ZERO = mpq(0)

# Which anchors have fans beside the gaps that get apexes; and the reaches of the fans in heights, in order of trial.
Mode = Literal["AB", "A", "B"]
MODES: tuple[Mode, ...] = ("AB", "A", "B")
REACHES = (2, 1, 3)


class Candidate(NamedTuple):
    """A triangulation in the frame: its signed squared feature size, faces counter-clockwise, new points."""

    value: mpq
    faces: tuple[Cycle, ...]
    steiner: tuple[Point, ...] = ()


@dataclass(frozen=True, slots=True)
class Frame:
    """A one-sided quadrilateral with u_j = (u[j], 0), u[0] = 0, and the anchors a, b above the T-side.

    Faces refer to u_j by j, to the anchors by `left` and `right`. Lengths are `l` times the true ones,
    l^2 = `scale_squared`.
    """

    u: tuple[mpq, ...]
    a: Point
    b: Point
    origin: Point
    along: Point
    mirrored: bool

    @property
    def scale_squared(self) -> mpq:
        """The square of the factor by which lengths in the frame are larger."""
        return dot(self.along, self.along)

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
        return [*(Point(u, _ZERO) for u in self.u), self.a, self.b]

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

    def gaps_between_fans(self, mode: Mode, reach: int) -> range | None:
        """Return the gaps [u_j, u_j+1] left between the fans of the anchors; None when there are none.

        The fan of A takes the initial run of u with u <= x_A + reach * h_A, that of B the final one likewise; in mode
        "A" there is no fan of B, in mode "B" none of A.
        """
        start, end = 0, len(self.u) - 1
        if mode != "B":
            while start < len(self.u) - 1 and self.u[start + 1] <= self.a.x + reach * self.a.y:
                start += 1
        if mode != "A":
            while end > 0 and self.u[end - 1] >= self.b.x - reach * self.b.y:
                end -= 1
        return range(start, end) if start < end else None

    def fans(self, gaps: range) -> list[Cycle]:
        """Return the faces of the two fans beside the given gaps."""
        faces: list[Cycle] = [(j, j + 1, self.left) for j in range(gaps.start)]
        return faces + [(j, j + 1, self.right) for j in range(gaps.stop, len(self.u) - 1)]

    def piece(self, chosen: Candidate) -> Piece:
        """Return a candidate in the plane, counter-clockwise there."""
        d, scale = self.along, self.scale_squared
        side = -1 if self.mirrored else 1
        steiner = tuple(Point(self.origin.x + (p.x * d.x - side * p.y * d.y) / scale,
                              self.origin.y + (p.x * d.y + side * p.y * d.x) / scale) for p in chosen.steiner)
        faces = tuple(face[::-1] for face in chosen.faces) if self.mirrored else chosen.faces
        return Piece(faces, steiner)


def frame_of(t_side: Sequence[Point], a: Point, b: Point) -> Frame:
    """Return the frame of the quadrilateral with the given T-side and anchors.

    It is mirrored when the quadrilateral u_0, u_m, b, a, by its signed area, lies on the right of the T-side; an
    anchor by itself may lie on the other side.
    """
    origin, end = t_side[0], t_side[-1]
    along = minus(end, origin)
    # Twice the area of the quadrilateral is the cross product of its diagonals.
    mirrored = cross(minus(b, origin), minus(a, end)) < 0
    side = -1 if mirrored else 1

    def local(p: Point) -> Point:
        q = minus(p, origin)
        return Point(dot(q, along), side * cross(along, q))

    return Frame(tuple(dot(minus(p, origin), along) for p in t_side), local(a), local(b), origin, along, mirrored)
