"""Collects faces and new vertices as steps make them; small regions are triangulated together at the end."""

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Literal

from exactmesh.geometry.columns import Columns, indices
from exactmesh.geometry.point import Point
from exactmesh.steps.balance import REPAIRED, Balance
from exactmesh.steps.pieces import OneSided, triangulate_one_sided_ones, triangulate_quads
from exactmesh.steps.records import Cycle, Patch, Piece

_Sort = Literal["vertex", "face", "triangle", "quad", "one-sided"]
# A triangle that turns right as given, and one that turns left.
_TURNS = (Piece(((0, 2, 1),)), Piece(((0, 1, 2),)))


class PatchBuilder:
    """Faces and new vertices as they are made; `proper` asks for faces of three vertices, `balance` for a feature size.

    A vertex has a number at once, by which it is known here. In the patch that comes out, vertices are numbered in the
    order in which they, and the quadrilaterals that get further ones, were added. `face_counts` then has the numbers of
    faces of what was added, in order.
    """

    def __init__(self, points: Sequence[Point], proper: bool = False, balance: Balance = REPAIRED) -> None:
        self.proper = proper
        self.balance = balance
        self.points = list(points)
        self._given = points if isinstance(points, Columns) else None
        self.first = len(points)
        self.on_edge: list[tuple[int, int]] = []
        self.face_counts: list[int] = []
        self._order: list[_Sort] = []
        self._faces: list[Cycle] = []
        self._triangles: list[Cycle] = []
        self._quads: list[Cycle] = []
        self._one_sided: list[OneSided] = []

    def finished(self) -> Patch:
        """Return what was made."""
        number = list(range(self.first))
        new: list[Point] = []
        faces: list[Cycle] = []
        made = self._made()
        for sort in self._order:
            if sort == "vertex":
                new.append(self.points[len(number)])
                number.append(self.first + len(new) - 1)
                continue
            piece, names = next(made[sort])
            self.face_counts.append(len(piece.faces))
            places = [number[v] for v in names]
            if piece.steiner:
                # New vertices from the last to the first, so that -1 - i counts from the end.
                end = self.first + len(new)
                places += range(end + len(piece.steiner) - 1, end - 1, -1)
                new += piece.steiner
            try:
                faces += [(places[i], places[j], places[k]) for i, j, k in piece.faces]
            except ValueError:  # not all of them have three vertices
                faces += [tuple([places[v] for v in face]) for face in piece.faces]
        return Patch(self.first, tuple(new), tuple(faces), tuple((edge, number[v]) for edge, v in self.on_edge))

    def _made(self) -> dict[_Sort, Iterator[tuple[Piece, Sequence[int]]]]:
        """Return the pieces of each sort in the order in which they were added, with the vertices they refer to."""
        points = self._given.extended(self.points[self.first :]) if self._given else Columns(self.points)
        wanted = self.balance.feature_squared
        left = points.turns(*indices(chain.from_iterable(self._triangles)).reshape(-1, 3).T) > 0
        return {
            "face": ((Piece((tuple(range(len(face))),)), face) for face in self._faces),
            "triangle": zip((_TURNS[turn] for turn in left.tolist()), self._triangles, strict=True),
            "quad": zip(triangulate_quads(points, self._quads, wanted), self._quads, strict=True),
            "one-sided": zip(triangulate_one_sided_ones(points, self._one_sided, self.proper, wanted),
                             ((*t_side, a, b) for t_side, a, b in self._one_sided), strict=True)}

    def add(self, point: Point) -> int:
        """Return the number of a new vertex."""
        self._order.append("vertex")
        self.points.append(point)
        return len(self.points) - 1

    def add_face(self, cycle: Cycle) -> None:
        """Add a face given counter-clockwise, with all its vertices."""
        self._order.append("face")
        self._faces.append(cycle)

    def add_triangle(self, a: int, b: int, c: int) -> None:
        """Add a triangle given either way round."""
        self._order.append("triangle")
        self._triangles.append((a, b, c))

    def add_quad(self, corners: Sequence[int]) -> None:
        """Triangulate a clean quadrilateral given as bottom left, bottom right, top right, top left."""
        self._order.append("quad")
        self._quads.append(tuple(corners))

    def add_one_sided(self, t_side: Sequence[int], a: int, b: int) -> None:
        """Triangulate a quadrilateral with T-vertices on one side only; a T-side of one vertex is a point."""
        if len(t_side) == 1:
            self.add_triangle(t_side[0], a, b)
            return
        self._order.append("one-sided")
        self._one_sided.append(OneSided(tuple(t_side), a, b))

    def add_piece(self, piece: Piece, names: Sequence[int]) -> None:
        """Take over a piece whose index i stands for the vertex names[i]."""
        new = [self.add(p) for p in piece.steiner]
        for face in piece.faces:
            self.add_face(tuple(names[v] if v >= 0 else new[-1 - v] for v in face))
