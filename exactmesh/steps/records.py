"""Records that a step hands to the next one and to its checker.

Vertices of the mesh to be are numbered once and for all: the vertices of P, then those of the offset Q, then chord
ends, then what the interior adds (feet and Steiner vertices), then what the Tube adds. `first` is the number of a
record's first new vertex. Coordinates are in units of the mfs, so that mfs(P) is 1 or a hair more.

A *corner* of a face of P is named by the half-edge that leaves it along the face's walk, or by -1 - v for an
isolated vertex v. Edge k of Q runs from vertex k of Q to the next vertex of its ring.
"""

from dataclasses import dataclass
from typing import Literal, NamedTuple

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.numbers.algebraic import Real
from exactmesh.steps.constants import LEVEL

Cycle = tuple[int, ...]
_HALF = mpq(1, 2)


@dataclass(frozen=True, slots=True)
class Shape:
    """P in units of `unit`: its points, and the walks of each face to be meshed as half-edges.

    `origin[h]` is the vertex that half-edge h leaves; its target is `origin[h ^ 1]`. `faces[f]` has the walks of one
    face, `isolated[f]` its isolated vertices. Faces that are bare triangles are in `triangles` instead.
    """

    unit: mpq
    points: tuple[Point, ...]
    origin: tuple[int, ...]
    faces: tuple[tuple[Cycle, ...], ...]
    isolated: tuple[tuple[int, ...], ...]
    triangles: tuple[Cycle, ...]

    @property
    def corner_count(self) -> int:
        """The number of corners of all walks; an isolated vertex counts as one."""
        return (sum(len(walk) for walks in self.faces for walk in walks) + sum(map(len, self.isolated))
                + 3 * len(self.triangles))


@dataclass(frozen=True, slots=True)
class Offset:
    """The inner offset on levels, Q (or the paper's P4): vertex k is at (x[k], height(level[k])).

    `rings[r]` is the half-open range of the vertices of one ring; the interior lies on the left. `corner[k]` is the
    corner vertex k belongs to; `source[k]` is the half-edge whose offset edge k is, or -1 when it is an edge of a cap.
    """

    first: int
    x: tuple[mpq, ...]
    level: tuple[int, ...]
    corner: tuple[int, ...]
    source: tuple[int, ...]
    rings: tuple[tuple[int, int], ...]
    points: tuple[Point, ...]
    spacing: mpq = LEVEL
    shift: mpq = _HALF

    def height(self, level: int) -> mpq:
        """Return the ordinate of a level."""
        return (level + self.shift) * self.spacing

    def successors(self) -> list[int]:
        """Return, for each vertex of Q, the next one of its ring."""
        following = list(range(1, len(self.x) + 1))
        for start, end in self.rings:
            following[end - 1] = start
        return following


@dataclass(frozen=True, slots=True)
class Trapezoid:
    """A face of the trapezoidation between two levels; corners and T-vertices are vertex numbers.

    `left` and `right` are the edges of Q its legs lie on. `top` and `bottom` list the T-vertices of the horizontal
    sides from left to right. A corner below `Trapezoidation.first` is a vertex of Q. At an apex two corners are equal.
    """

    low: int
    high: int
    left: int
    right: int
    bl: int
    br: int
    tr: int
    tl: int
    bottom: Cycle
    top: Cycle


@dataclass(frozen=True, slots=True)
class Trapezoidation:
    """The horizontal trapezoidation of Q: chord end i is the vertex `first` + i at `points[i]`, on edge `edge[i]`."""

    first: int
    points: tuple[Point, ...]
    edge: tuple[int, ...]
    trapezoids: tuple[Trapezoid, ...]


@dataclass(frozen=True, slots=True)
class Patch:
    """Faces of the mesh to be, with the vertices they add; `on_edge` lists the added vertices on edges of Q.

    A face is the counter-clockwise cycle of all vertices on it. `on_edge` has pairs (edge of Q, vertex).
    """

    first: int
    points: tuple[Point, ...]
    faces: tuple[Cycle, ...]
    on_edge: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class Piece:
    """A small region triangulated: in `faces` a negative number -1 - i stands for the new vertex `steiner[i]`."""

    faces: tuple[Cycle, ...]
    steiner: tuple[Point, ...] = ()


class RealPoint(NamedTuple):
    """A place with algebraic coordinates."""

    x: Real
    y: Real


@dataclass(frozen=True, slots=True)
class CurveCorner:
    """What the paper's offset curve has at one corner, named by its half-edge as elsewhere.

    `vertices` are the corner's vertices of P3: one, or the ends and the middle of an arc ("chords"). `arc` has the
    two ends of the arc of P2 at a reflex corner.
    """

    kind: Literal["convex", "flat", "prolonged", "chords"]
    corner: int
    vertices: tuple[RealPoint, ...]
    arc: tuple[RealPoint, RealPoint] | None = None


@dataclass(frozen=True, slots=True)
class OffsetCurve:
    """P2 and P3 at distance mfs/4: `rings` has the corners of each walk in its order."""

    mfs_squared: mpq
    rings: tuple[tuple[CurveCorner, ...], ...]


@dataclass(frozen=True, slots=True)
class UnitPiece:
    """A triangulated rectangle in units of its spacing across and of its height upwards.

    In `faces` j stands for the bottom vertex j, the next two numbers for the upper left and right corner, -1 - i for
    the new vertex `steiner[i]`.
    """

    faces: tuple[Cycle, ...]
    steiner: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Rectangle:
    """One of the paper's rectangles a b b' a' in the Tube: `side` runs from b to a along P4 with the vertices between.

    `edge` is the half-edge of P below it, `grid` the places of `side` as numbers of grid lines from b.
    """

    edge: int
    side: Cycle
    grid: tuple[int, ...]
    a_below: int
    b_below: int


Phase = Literal["fan", "cut", "rest", "tall", "low", "rectangle"]


@dataclass(frozen=True, slots=True)
class PaperTube:
    """The paper's Tube. `phase[i]` tells where face i of the patch comes from.

    "fan" phase 1, at a corner; "cut" phase 2, triangles cut off at the ends of the top; "rest" phase 2, the triangles
    beside a rectangle; "tall" phase 3 in a quasi-trapz between P and P4; "low" phase 3 below a rectangle;
    "rectangle" phase 4.
    """

    patch: Patch
    phase: tuple[Phase, ...]
    rectangles: tuple[Rectangle, ...]
