"""One cell of the strip: the rectangle of height epsilon that a slice of a triangle becomes.

The triangle stands on its longest side, of length w, start at (0, 0), apex at (f w, 2 h), 0 < f < 1. Cut at mid-height
and along the altitude above; the upper parts make half-turns about (f w / 2, h) and ((1 + f) w / 2, h), the middles
of the other two sides, and there is the rectangle w x h. Let area be the triangle's, so h = area / w.

Slice j of the rectangle, k slices in all, has the height g = h / k in [epsilon, 2 epsilon) and becomes a rectangle of
width v = area / (k epsilon), rational, and height epsilon. Both have a corner at (0, 0). The line x + (w / epsilon) y =
v goes through (0, g) and (v, 0). What of the slice is above it moves by (v - w, epsilon - g); what is below it and
above y = epsilon moves by (w, -epsilon); the rest stays. This needs v <= 2 w, that is g <= 2 epsilon.

In the strip the cell is therefore cut by one slanted line, by the line x = w below that, and each of the three parts by
the triangle's two sides, which do not meet below mid-height: 9 convex parts at most. Every cut goes right through what
is there to be cut.
"""

from dataclasses import dataclass

from gmpy2 import isqrt, mpq

from exactmesh.dissection.figure import Figure
from exactmesh.dissection.records import Motion
from exactmesh.dissection.region import Line, Region, split
from exactmesh.dissection.triangles import Triangle
from exactmesh.geometry.point import dot, minus
from exactmesh.numbers.algebraic import Real, sqrt

MAX_PARTS = 9


@dataclass(frozen=True, slots=True)
class Cut:
    """A line, and what becomes of either side of it: another cut, or the motion from the strip to the figure."""

    line: Line
    negative: "Cut | Motion"
    positive: "Cut | Motion"


@dataclass(frozen=True, slots=True)
class Cell:
    """What stands between x = left and x = right in the strip of one figure."""

    left: mpq
    right: mpq
    cuts: Cut


def parts(region: Region, node: Cut | Motion) -> list[tuple[Region, Motion]]:
    """Return the parts into which the cuts of a cell take a region of it, with their motions to the figure."""
    if isinstance(node, Motion):
        return [(region, node)]
    negative, positive = split(region, node.line)
    found = [] if negative is None else parts(negative, node.negative)
    return found if positive is None else found + parts(positive, node.positive)


def cells_of(figure: Figure, triangle: Triangle, epsilon: mpq, left: mpq) -> list[Cell]:
    """Return the cells of one triangle, side by side from `left` on."""
    count = int(isqrt(figure.scale_squared * triangle.half_height_squared // epsilon**2))
    area = figure.scale_squared * triangle.area
    width = area / (count * epsilon)
    frame = _Frame(figure, triangle)
    return [frame.cell(j, count, epsilon, left + j * width, width) for j in range(count)]


class _Frame:
    """The triangle in its own frame, after scaling; `plane` carries that to the figure."""

    def __init__(self, figure: Figure, triangle: Triangle) -> None:
        along = minus(triangle.end, triangle.start)
        self.base_squared = figure.scale_squared * triangle.base_squared
        self.base = sqrt(self.base_squared)
        self.area = figure.scale_squared * triangle.area
        self.height = self.base * (self.area / self.base_squared)
        self.foot = dot(minus(triangle.apex, triangle.start), along) / triangle.base_squared
        inverse = sqrt(triangle.base_squared) / triangle.base_squared
        cosine, sine = inverse * along.x, inverse * along.y
        self.plane = Motion(cosine, -sine, sine, cosine, figure.scale * triangle.start.x,
                            figure.scale * triangle.start.y)

    def cell(self, j: int, count: int, epsilon: mpq, left: mpq, width: mpq) -> Cell:
        """Return slice j of `count` as a cell."""
        low = self.height * mpq(j, count)
        rise = self.height * mpq(1, count) - epsilon
        stays = self._sides(Real(-left), low)
        right = left + width
        if not rise:
            return Cell(left, right, stays)
        above = self._sides(self.base - (left + width), low + rise)
        beyond = self._sides(-self.base - left, low + epsilon)
        upright = Line(Real(1), Real(0), -self.base - left)
        slanted = Line(Real(1), self.base / epsilon, Real(-right))
        return Cell(left, right, Cut(slanted, Cut(upright, stays, beyond), above))

    def _sides(self, across: Real, up: Real) -> Cut:
        """Return the cuts by the triangle's sides; (x, y) in the strip is (x + across, y + up) in the rectangle."""
        area, base_squared, foot = 2 * self.area, self.base_squared, self.foot
        start_side = self._line(area, -foot * base_squared, Real(0), across, up)
        end_side = self._line(area, (1 - foot) * base_squared, self.base * -area, across, up)
        inside = _after(self.plane, 1, across, up)
        start_turn = _after(self.plane, -1, self.base * foot - across, 2 * self.height - up)
        end_turn = _after(self.plane, -1, self.base * (1 + foot) - across, 2 * self.height - up)
        return Cut(start_side, start_turn, Cut(end_side, inside, end_turn))

    @staticmethod
    def _line(a: mpq, b: mpq, c: Real, across: Real, up: Real) -> Line:
        """Return a x + b y + c = 0 of the rectangle, in the strip."""
        return Line(Real(a), Real(b), c + across * a + up * b)


def _after(plane: Motion, sign: int, x: Real, y: Real) -> Motion:
    """Return p -> plane(sign * p + (x, y))."""
    return Motion(sign * plane.a, sign * plane.b, sign * plane.c, sign * plane.d,
                  plane.a * x + plane.b * y + plane.x, plane.c * x + plane.d * y + plane.y)
