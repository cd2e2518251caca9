"""Collects faces and new vertices as steps make them."""

from collections.abc import Sequence

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.one_sided import triangulate_one_sided
from exactmesh.steps.quad import quad
from exactmesh.steps.records import Cycle, Patch, Piece


class PatchBuilder:
    """Faces and new vertices as they are made; `proper` asks for faces of three vertices."""

    def __init__(self, points: Sequence[Point], proper: bool = False) -> None:
        self.proper = proper
        self.points = list(points)
        self.first = len(points)
        self.faces: list[Cycle] = []
        self.on_edge: list[tuple[int, int]] = []

    def finished(self) -> Patch:
        """Return what was made."""
        return Patch(self.first, tuple(self.points[self.first :]), tuple(self.faces), tuple(self.on_edge))

    def add(self, point: Point) -> int:
        """Return the number of a new vertex."""
        self.points.append(point)
        return len(self.points) - 1

    def add_face(self, cycle: Cycle) -> None:
        """Add a face given counter-clockwise, with all its vertices."""
        self.faces.append(cycle)

    def add_triangle(self, a: int, b: int, c: int) -> None:
        """Add a triangle given either way round."""
        turns_left = doubled_area(self.points[a], self.points[b], self.points[c]) > 0
        self.faces.append((a, b, c) if turns_left else (a, c, b))

    def add_quad(self, corners: Sequence[int]) -> None:
        """Triangulate a clean quadrilateral given as bottom left, bottom right, top right, top left."""
        self.add_piece(quad([self.points[v] for v in corners]), corners)

    def add_one_sided(self, t_side: Sequence[int], a: int, b: int) -> None:
        """Triangulate a quadrilateral with T-vertices on one side only; a T-side of one vertex is a point."""
        if len(t_side) == 1:
            self.add_triangle(t_side[0], a, b)
            return
        piece = triangulate_one_sided([self.points[v] for v in t_side], self.points[a], self.points[b], self.proper)
        self.add_piece(piece, (*t_side, a, b))

    def add_piece(self, piece: Piece, names: Sequence[int]) -> None:
        """Take over a piece whose index i stands for the vertex names[i]."""
        new = [self.add(p) for p in piece.steiner]
        self.faces += [tuple(names[v] if v >= 0 else new[-1 - v] for v in face) for face in piece.faces]
