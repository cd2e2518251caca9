"""The internal feature size (ifs) of a domain, exactly, with its witness.

ifs is the least distance, over the faces of the domain, between a vertex of a face and a feature of it, an edge or a
vertex, that does not contain the vertex, measured along segments that lie in the closed face and cross no edge. Faces
count each for itself, so both sides of an edge that two faces share count, and so do both sides of a dangling edge;
what is near only across a hole or the outside does not. A vertex is at no distance from itself: two corners at one
vertex are no pair.

Only the point of a feature that is nearest to the vertex matters. From any other point that the vertex sees, one can
move towards it; the segment grows shorter until it arrives, or until something nearer is in the way.

The vertices look through the constrained Delaunay triangulation: from each corner of each triangle through the
opposite side, while it is no input edge and no farther than the best pair so far. What is seen through a row of sides
is a cone between two of their ends, and each turn is decided exactly. Distances are rounded only to leave out pairs
and sides that are too far by more than their error (`SLACK`, see `exactmesh.measure.candidates`). The circles of the
triangulation are empty, so few sides are looked through; the worst case is quadratic.
"""

from collections.abc import Iterator, Sequence
from math import hypot

from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.filtered import FilteredPoints, unit_floats
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.measure.candidates import SLACK
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared, face_witness
from exactmesh.measure.mfs import Nearest
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge
from exactmesh.planar.triangulation import Triangulation


def internal_feature_size(subdivision: Subdivision) -> Nearest | None:
    """Return the squared internal feature size of the domain and a pair that has it; None without a domain.

    The feature is an edge when its nearest point lies in its interior, otherwise a vertex. Among equally near pairs,
    edges come before vertices and lower indices first.
    """
    return nearest_seen(subdivision.pslg.vertices, constrained_delaunay(subdivision))


def nearest_seen(points: Sequence[Point], triangulation: Triangulation) -> Nearest | None:
    """Return `internal_feature_size` of the domain that is triangulated; None without triangles.

    Any triangulation of the domain will do; its constrained sides are the edges.
    """
    best: tuple[mpq, bool, Edge, int] | None = None
    for vertex, (a, b) in _Search(points, triangulation).run():
        if a == b:
            a, b, vertex = min(a, vertex), min(a, vertex), max(a, vertex)
        elif not _is_beside(points[vertex], points[a], points[b]):
            continue  # The end is seen as well.
        squared = segment_distance_squared(points[vertex], points[a], points[b])
        key = (squared, a == b, (min(a, b), max(a, b)), vertex)
        if best is None or key < best:
            best = key
    return None if best is None else Nearest(best[0], best[3], best[2])


def mesh_ifs(mesh: Mesh) -> Nearest | None:
    """Return the squared internal feature size of a valid mesh and a pair that has it; None without faces.

    Every face is convex and everything in it is seen from its vertices, so this is the least feature size of a face:
    where faces have three vertices, the least height. Raises `ValueError` for a face that is no triangle.
    """
    least: tuple[mpq, int] | None = None
    for number, cycle in enumerate(mesh.faces):
        corners = corners_of(mesh.vertices, cycle)
        if isinstance(corners, NotTriangle):
            raise ValueError(f"face {number} {corners.reason} at vertex {corners.vertex}")
        feature = face_feature_squared(mesh.vertices, cycle, corners)
        if least is None or feature < least[0]:
            least = feature, number
    return None if least is None else face_witness(mesh.vertices, mesh.faces[least[1]])


def _is_beside(p: Point, a: Point, b: Point) -> bool:
    """Return whether the perpendicular from p to the line a b arrives strictly between a and b."""
    along = minus(b, a)
    return bool(dot(minus(p, a), along) > 0 > dot(minus(p, b), along))


class _Search:
    """`reach` is an upper bound of the ifs, up to rounding; `found` holds pairs with their rounded distances."""

    def __init__(self, points: Sequence[Point], triangulation: Triangulation) -> None:
        self.points = points
        self.apex, self.constrained = triangulation.apex, triangulation.constrained
        self.orientation = FilteredPoints(points).orientation
        self.x, self.y, _ = unit_floats(points)
        self.reach = float("inf")
        self.found: list[tuple[float, int, Edge]] = []

    def run(self) -> Iterator[tuple[int, Edge]]:
        """Return pairs of a vertex and a feature that it sees, among them all pairs at the least distance."""
        within: list[tuple[float, int, Edge]] = []
        for (a, b), v in self.apex.items():
            self._meet(v, (a, a))
            distance = self._distance(v, a, b)
            if (a, b) in self.constrained:
                self._keep(distance, v, (a, b))
            else:
                within.append((distance, v, (a, b)))
        for distance, v, (a, b) in within:
            if distance <= self.reach + 2 * SLACK:
                self._look_through(v, a, b)
        return ((v, feature) for distance, v, feature in self.found if distance <= self.reach + 2 * SLACK)

    def _meet(self, v: int, feature: Edge) -> None:
        """Take a pair into account."""
        self._keep(self._distance(v, *feature), v, feature)

    def _keep(self, distance: float, v: int, feature: Edge) -> None:
        if distance <= self.reach + 2 * SLACK:
            self.found.append((distance, v, feature))
            self.reach = min(self.reach, distance)

    def _distance(self, v: int, a: int, b: int) -> float:
        """Return the distance of v from the segment a b, off by at most SLACK."""
        ax, ay = self.x[a], self.y[a]
        px, py = self.x[v] - ax, self.y[v] - ay
        dx, dy = self.x[b] - ax, self.y[b] - ay
        length_squared = dx * dx + dy * dy
        t = min(max((px * dx + py * dy) / length_squared, 0.0), 1.0) if length_squared > 0 else 0.0
        return hypot(px - t * dx, py - t * dy)

    def _look_through(self, v: int, a: int, b: int) -> None:
        """Take into account what v sees beyond the side a b, no input edge, of a triangle v a b."""
        orientation = self.orientation
        # Sides to look through, each with the vertices that bound the cone on the right and on the left.
        pending = [(a, b, a, b)]
        while pending:
            a, b, right, left = pending.pop()
            c = self.apex[b, a]
            is_left_of_right, is_right_of_left = orientation(v, right, c) > 0, orientation(v, left, c) < 0
            if is_left_of_right and is_right_of_left:
                self._meet(v, (c, c))
            # On the boundary of the cone c is hidden by the vertex that bounds it.
            if is_left_of_right:
                self._side(v, a, c, right, c if is_right_of_left else left, pending)
            if is_right_of_left:
                self._side(v, c, b, c if is_left_of_right else right, left, pending)

    def _side(self, v: int, a: int, b: int, right: int, left: int, pending: list[tuple[int, int, int, int]]) -> None:
        """Look at the side a b, of which v sees what lies between its directions to `right` and `left`."""
        distance = self._distance(v, a, b)
        if distance > self.reach + 2 * SLACK:
            return
        if (a, b) not in self.constrained:
            pending.append((a, b, right, left))
        elif self._sees_foot(v, a, b, right, left):
            self._keep(distance, v, (a, b))

    def _sees_foot(self, v: int, a: int, b: int, right: int, left: int) -> bool:
        """Return whether the perpendicular from v to the line a b, which v has on its left, lies in the cone."""
        points = self.points
        along = minus(points[b], points[a])
        return bool(dot(minus(points[right], points[v]), along) <= 0 <= dot(minus(points[left], points[v]), along))
