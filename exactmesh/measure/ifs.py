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
and sides that are too far by more than their error (`SLACK`, see `exactmesh.measure.candidates`). Since the circles of
the triangulation are empty, few sides are looked through, except near the ends of long edges; when it gets many, the
edges are cut first (`exactmesh.planar.projection`), at points that are no vertices.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import hypot

from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.filtered import FilteredPoints, unit_floats
from exactmesh.geometry.fixed_point import FixedPoints
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.measure.candidates import SLACK
from exactmesh.measure.face_feature import face_witness
from exactmesh.measure.mesh_faces import MeshFaces
from exactmesh.measure.mfs import Nearest
from exactmesh.planar.cycles import Side
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.projection import project
from exactmesh.planar.pslg import Edge
from exactmesh.planar.triangulation import Triangulation

# Sides looked through, for each side of the triangulation, after which edges are cut first.
_MANY = 2


def internal_feature_size(subdivision: Subdivision) -> Nearest | None:
    """Return the squared internal feature size of the domain and a pair that has it; None without a domain.

    The feature is an edge when its nearest point lies in its interior, otherwise a vertex. Among equally near pairs,
    edges come before vertices and lower indices first.
    """
    return nearest_seen(subdivision.pslg.vertices, constrained_delaunay(subdivision))


def nearest_seen(points: Sequence[Point], triangulation: Triangulation) -> Nearest | None:
    """Return `internal_feature_size` of the domain with a given constrained Delaunay triangulation; None without
    triangles. Any other triangulation gives the same answer, later."""
    search = _Search(points, triangulation, len(points), {})
    search.look_around()
    if not search.look_farther(_MANY * len(triangulation.apex)):
        cut = project(points, triangulation, 4 * search.reach)
        again = _Search(cut.points, cut.triangulation, len(points), cut.edge_of)
        again.found, again.reach = search.found, search.reach
        again.look_around()
        again.look_farther(None)
        search = again
    best: tuple[mpq, bool, Edge, int] | None = None
    for vertex, feature in search.nearest():
        a, b = feature
        if a == b:
            a, b, vertex = min(a, vertex), min(a, vertex), max(a, vertex)
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
    faces = MeshFaces(FixedPoints(mesh.vertices), mesh.faces)
    for number, refused in faces.not_triangles():
        raise ValueError(f"face {number} {refused.reason} at vertex {refused.vertex}")
    return mesh_ifs_of(mesh, faces)


def mesh_ifs_of(mesh: Mesh, faces: MeshFaces) -> Nearest | None:
    """Return `mesh_ifs` of a mesh whose faces are arranged already, and are known to be triangles."""
    least = faces.least_feature()
    return None if least is None else face_witness(mesh.vertices, mesh.faces[least[1]])


class _Search:
    """Vertices from `given` on lie on edges: `edge_of` has the whole edges of which constrained sides are parts.

    `reach` is an upper bound of the ifs, up to rounding; `found` holds rounded distances, vertices, and features of
    which they see the nearest point: edges, vertices twice over.
    """

    def __init__(self, points: Sequence[Point], triangulation: Triangulation, given: int, edge_of: Mapping[Side, Edge]
                 ) -> None:
        self.points, self.given, self.edge_of = points, given, edge_of
        self.apex, self.constrained = triangulation.apex, triangulation.constrained
        self.orientation = FilteredPoints(points).orientation
        self.x, self.y, _ = unit_floats(points)
        self.reach = float("inf")
        self.found: list[tuple[float, int, Edge]] = []

    def look_around(self) -> None:
        """Take into account what each vertex sees in the triangles at it."""
        for (a, b), v in self.apex.items():
            if v < self.given:
                self._meet(v, a)
                if (a, b) in self.constrained:
                    self._meet_side(v, a, b, self._distance(v, a, b))

    def look_farther(self, limit: int | None) -> bool:
        """Take into account what vertices see through sides; return whether `limit` steps suffice."""
        near = [(v, a, b) for (a, b), v in self.apex.items() if v < self.given and (a, b) not in self.constrained
                and self._distance(v, a, b) <= self.reach + 2 * SLACK]
        steps = 0
        for v, a, b in near:
            steps += self._look_through(v, a, b)
            if limit is not None and steps > limit:
                return False
        return True

    def nearest(self) -> Iterator[tuple[int, Edge]]:
        """Return pairs of a vertex and a feature, among them all pairs at the least distance."""
        return ((v, feature) for distance, v, feature in self.found if distance <= self.reach + 2 * SLACK)

    def _meet(self, v: int, w: int) -> None:
        """Take into account that v sees the vertex w."""
        if w < self.given:
            self._keep(self._distance(v, w, w), v, (w, w))

    def _meet_side(self, v: int, a: int, b: int, distance: float) -> None:
        """Take into account that v sees the foot on the constrained side a b, if it lies there."""
        edge = self.edge_of.get((a, b), (a, b))
        if distance <= self.reach + 2 * SLACK and self._is_beside(v, a, b, closed=True) and self._is_beside(v, *edge):
            self._keep(distance, v, edge)

    def _keep(self, distance: float, v: int, feature: Edge) -> None:
        if distance <= self.reach + 2 * SLACK:
            self.found.append((distance, v, feature))
            self.reach = min(self.reach, distance)

    def _is_beside(self, v: int, a: int, b: int, closed: bool = False) -> bool:
        """Return whether the foot of v on the line a b lies between a and b."""
        p, q, r = self.points[v], self.points[a], self.points[b]
        along = minus(r, q)
        before, after = dot(minus(p, q), along), dot(minus(p, r), along)
        return bool(before >= 0 >= after if closed else before > 0 > after)

    def _distance(self, v: int, a: int, b: int) -> float:
        """Return the distance of v from the segment a b, off by at most SLACK."""
        ax, ay = self.x[a], self.y[a]
        px, py = self.x[v] - ax, self.y[v] - ay
        dx, dy = self.x[b] - ax, self.y[b] - ay
        length_squared = dx * dx + dy * dy
        t = min(max((px * dx + py * dy) / length_squared, 0.0), 1.0) if length_squared > 0 else 0.0
        return hypot(px - t * dx, py - t * dy)

    def _look_through(self, v: int, a: int, b: int) -> int:
        """Take into account what v sees beyond the side a b, no input edge, of a triangle v a b; count the steps."""
        orientation = self.orientation
        steps = 0
        # Sides to look through, each with the vertices that bound the cone on the right and on the left.
        pending = [(a, b, a, b)]
        while pending:
            steps += 1
            a, b, right, left = pending.pop()
            c = self.apex[b, a]
            is_left_of_right, is_right_of_left = orientation(v, right, c) > 0, orientation(v, left, c) < 0
            # On the boundary of the cone c is hidden by the vertex that bounds it.
            if is_left_of_right and is_right_of_left:
                self._meet(v, c)
            if is_left_of_right:
                self._look_at(v, a, c, right, c if is_right_of_left else left, pending)
            if is_right_of_left:
                self._look_at(v, c, b, c if is_left_of_right else right, left, pending)
        return steps

    def _look_at(self, v: int, a: int, b: int, right: int, left: int, pending: list[tuple[int, int, int, int]]
                 ) -> None:
        """Look at the side a b, of which v sees what lies between its directions to `right` and `left`."""
        distance = self._distance(v, a, b)
        if distance > self.reach + 2 * SLACK:
            return
        if (a, b) not in self.constrained:
            pending.append((a, b, right, left))
        elif self._sees_foot(v, a, b, right, left):
            self._meet_side(v, a, b, distance)

    def _sees_foot(self, v: int, a: int, b: int, right: int, left: int) -> bool:
        """Return whether the perpendicular from v to the line a b, which v has on its left, lies in the cone."""
        points = self.points
        along = minus(points[b], points[a])
        return bool(dot(minus(points[right], points[v]), along) <= 0 <= dot(minus(points[left], points[v]), along))
