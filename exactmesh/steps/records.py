"""Records that a step hands to the next one and to its checker.

Vertices of the mesh to be are numbered once and for all: the vertices of P, then those of the offset Q, then chord
ends, then what the interior adds (feet and Steiner vertices), then what the Tube adds. `first` is the number of a
record's first new vertex. Coordinates are in units of the mfs, so that mfs(P) is 1 or a hair more.

A *corner* of a face of P is named by the half-edge that leaves it along the face's walk, or by -1 - v for an
isolated vertex v. Edge k of Q runs from vertex k of Q to the next vertex of its ring.
"""

from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.point import Point

Cycle = tuple[int, ...]


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
    """Q, the inner offset on levels: vertex k is at (x[k], (level[k] + 1/2) g).

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
