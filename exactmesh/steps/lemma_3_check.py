"""Check the triangulated rectangles of the Tube: Lemma 3 and Theorem 2; neither step is imported. Values are squares.

A rectangle a b b' a' has the spacing w of its positions and the height h. Its faces are those of phase "rectangle" that
are connected with its side; b' is the corner where the anchored edges meet.

Hypothesis   h > w, as Lemma 3 asks.            Positions    vertices stand at multiples of w.
Tiling       it is a rectangle, tiled.          Boundary     nothing is added on its boundary.
Fan          vertices on an edge anchored at b' keep f1 = w (h/6) / sqrt((h/6)^2 + w^2) from the next such edge.
Teeth        faces away from b' and a' keep f2 = (h/3) (w/2) / sqrt((h/3)^2 + (w/2)^2); all positions are occupied.
Feature      all faces keep min(f1, f2).        Constant     all faces keep min(h, w) / sqrt(37).
Count        at most three new vertices a position; or, by `occupied`, a gap between vertices on the side.
Layers       (Theorem 2) faces keep min(h, w) / (sqrt(2) J) with J = 1 + floor(log2 n) rows of n vertices and less.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges, sides
from exactmesh.steps.records import Cycle, PaperTube, Rectangle


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle with its faces, and the squares of its spacing and height."""

    number: int
    record: Rectangle
    faces: tuple[Cycle, ...]
    w_squared: mpq
    h_squared: mpq

    @property
    def outline(self) -> Cycle:
        """The boundary with all its vertices, counter-clockwise."""
        return (*self.record.side, self.record.a_below, self.record.b_below)

    @property
    def new(self) -> list[int]:
        """The vertices that the triangulation adds."""
        return sorted({v for face in self.faces for v in face}.difference(self.outline))

    def f1_squared(self) -> mpq:
        """Return the square of the fan's bound."""
        w, h = self.w_squared, self.h_squared
        return w * h / (h + 36 * w)

    def f2_squared(self) -> mpq:
        """Return the square of the teeth's bound."""
        w, h = self.w_squared, self.h_squared
        return w * h / (4 * h + 9 * w)


def boxes(tube: PaperTube, points: Sequence[Point]) -> Iterator[Box]:
    """Yield the rectangles of the Tube with their faces, found from neighbour to neighbour."""
    inside = [face for face, phase in zip(tube.patch.faces, tube.phase, strict=True) if phase == "rectangle"]
    owner, _ = directed_edges(inside)
    for number, record in enumerate(tube.rectangles):
        found = dict.fromkeys(owner[side] for side in sides(record.side) if side in owner)
        queue = list(found)
        for face in queue:
            for u, v in sides(inside[face]):
                neighbour = owner.get((v, u))
                if neighbour is not None and neighbour not in found:
                    found[neighbour] = None
                    queue.append(neighbour)
        b, a = points[record.side[0]], points[record.side[-1]]
        yield Box(number, record, tuple(inside[face] for face in found), distance_squared(a, b) / record.grid[-1] ** 2,
                  distance_squared(a, points[record.a_below]))


def check_hypothesis(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least h^2/w^2; one instance a rectangle."""
    tally = Tally("h > w", ">", mpq(1))
    for box in boxes(tube, points):
        tally.see(box.h_squared / box.w_squared, rectangle=box.number, edge=box.record.edge >> 1)
    return tally.verdict()


def check_positions(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return whether vertices stand at the recorded multiples of w, which increase; one instance a rectangle."""
    for number, record in enumerate(tube.rectangles):
        b, a, grid = points[record.side[0]], points[record.side[-1]], record.grid
        if grid[0] != 0 or any(i >= j for i, j in pairwise(grid)) or len(grid) != len(record.side):
            return failed(number + 1, "positions increase from 0", rectangle=number)
        for v, j in zip(record.side, grid, strict=True):
            share = mpq(j, grid[-1])
            if points[v] != (b.x + (a.x - b.x) * share, b.y + (a.y - b.y) * share):
                return failed(number + 1, "vertices stand at multiples of w", rectangle=number, vertex=v)
    return Verdict(len(tube.rectangles), True)


def check_tiling(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return whether each rectangle is one, tiled by triangles; one instance a face."""
    count = 0
    for box in boxes(tube, points):
        a, b, a_below, b_below = _corners(box, points)
        if minus(b_below, b) != minus(a_below, a) or dot(minus(a, b), minus(b_below, b)) != 0:
            return failed(count, "a b b' a' is a rectangle", rectangle=box.number)
        for face in box.faces:
            count += 1
            if isinstance(corners_of(points, face), NotTriangle):
                return failed(count, "faces are triangles", rectangle=box.number, face=list(face))
        owner, repeated = directed_edges(box.faces)
        outer = {side for side in owner if side[::-1] not in owner}
        if repeated or outer != set(sides(box.outline)):
            return failed(count, "the faces' boundaries add up to the rectangle's", rectangle=box.number)
    if count != tube.phase.count("rectangle"):
        return failed(count, "every face belongs to a rectangle", faces=tube.phase.count("rectangle"))
    return Verdict(count, True)


def check_boundary(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return whether every new vertex is strictly inside its rectangle; one instance a new vertex."""
    count = 0
    for box in boxes(tube, points):
        a, b, a_below, b_below = _corners(box, points)
        for v in box.new:
            count += 1
            if any(orientation(p, q, points[v]) <= 0 for p, q in ((b, a), (a, a_below), (a_below, b_below),
                                                                  (b_below, b))):
                return failed(count, "new vertices are inside", rectangle=box.number, vertex=v, at=str(points[v]))
    return Verdict(count, True)


def check_fan(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared distance, over f1^2, of the vertices on the first of a face's two sides
    at b' from the second; one instance a face at b'."""
    tally = Tally("f1 is kept", ">=", mpq(1))
    for box in boxes(tube, points):
        anchor = box.record.b_below
        for face in box.faces:
            if anchor in face:
                squared = _first_side_from_second(face, anchor, points)
                tally.see(squared / box.f1_squared(), rectangle=box.number, face=list(face))
    return tally.verdict()


def check_teeth(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of the faces away from b' and a', over f2^2, in rectangles
    with a vertex at every position."""
    return _check_faces(tube, points, Tally("f2 is kept", ">=", mpq(1)), Box.f2_squared,
                        lambda box, face: len(box.record.grid) == box.record.grid[-1] + 1
                        and box.record.b_below not in face and box.record.a_below not in face)


def check_feature(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of all faces, over min(f1, f2)^2."""
    return _check_faces(tube, points, Tally("min(f1, f2) is kept", ">=", mpq(1)),
                        lambda box: min(box.f1_squared(), box.f2_squared()))


def check_constant(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of all faces, over min(h, w)^2."""
    return _check_faces(tube, points, Tally("min(h, w) / sqrt(37) is kept", ">=", mpq(1, 37)),
                        lambda box: min(box.h_squared, box.w_squared))


def check_count(tube: PaperTube, points: Sequence[Point], occupied: bool) -> Verdict:
    """Return the verdict on the number of new vertices for each position, or for each gap that is there."""
    tally = Tally("three new vertices each at most", "<=", mpq(3))
    for box in boxes(tube, points):
        whole = len(box.record.side) - 1 if occupied else box.record.grid[-1]
        tally.see(mpq(len(box.new), whole), rectangle=box.number, edge=box.record.edge >> 1)
    return tally.verdict()


def check_layers_feature(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of all faces, over (min(h, w) / (sqrt(2) J))^2."""
    return _check_faces(tube, points, Tally("min(h, w) / (sqrt(2) (1 + log2 n)) is kept", ">=", mpq(1)),
                        lambda box: min(box.h_squared, box.w_squared) / (2 * rows(box.record) ** 2))


def check_layer_count(tube: PaperTube, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the number of rows of vertices, that on the side included, over 1 + floor(log2 n)."""
    tally = Tally("1 + floor(log2 n) rows", "<=", mpq(1))
    for box in boxes(tube, points):
        _, b, _, b_below = _corners(box, points)
        up = minus(b_below, b)
        heights = {dot(minus(points[v], b), up) for v in (*box.new, box.record.side[0])}
        tally.see(mpq(len(heights), rows(box.record)), rectangle=box.number, edge=box.record.edge >> 1)
    return tally.verdict()


def check_proper(tube: PaperTube) -> Verdict:
    """Return whether all faces in rectangles have three vertices; one instance a face."""
    faces = [face for face, phase in zip(tube.patch.faces, tube.phase, strict=True) if phase == "rectangle"]
    for number, face in enumerate(faces):
        if len(face) != 3:
            return failed(number + 1, "faces have three vertices", face=list(face))
    return Verdict(len(faces), True)


def rows(record: Rectangle) -> int:
    """Return 1 + floor(log2 n) for the n vertices inside the side."""
    return (len(record.side) - 2).bit_length()


def _first_side_from_second(face: Cycle, anchor: int, points: Sequence[Point]) -> mpq:
    """Return the least squared distance of the vertices on the side of `face` that starts at the corner `anchor` from
    the side that ends there; zero for what is no triangle."""
    corners = corners_of(points, face)
    if isinstance(corners, NotTriangle):
        return mpq(0)
    turned = face[face.index(anchor) :] + face[: face.index(anchor)]
    _, end, other = sorted(turned.index(face[i]) for i in corners)
    return min(segment_distance_squared(points[v], points[anchor], points[turned[other]]) for v in turned[1 : end + 1])


def _check_faces(tube: PaperTube, points: Sequence[Point], tally: Tally, unit: Callable[[Box], mpq],
                 is_meant: Callable[[Box, Cycle], bool] = lambda box, face: True) -> Verdict:
    for box in boxes(tube, points):
        for face in box.faces:
            if is_meant(box, face):
                corners = corners_of(points, face)
                value = mpq(0) if isinstance(corners, NotTriangle) else face_feature_squared(points, face, corners)
                tally.see(value / unit(box), rectangle=box.number, face=list(face))
    return tally.verdict()


def _corners(box: Box, points: Sequence[Point]) -> tuple[Point, Point, Point, Point]:
    """Return the places of a, b, a', b'."""
    side = box.record.side
    return points[side[-1]], points[side[0]], points[box.record.a_below], points[box.record.b_below]
