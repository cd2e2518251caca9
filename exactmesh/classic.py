"""Classic meshes, without Steiner points: a fast one of any domain, and the best one of a simple polygon.

A triangulation's mfs is the least of the input's and of the least heights of its triangles (a shortest vertex-feature
segment crosses no edge, so it lies in one face). So the best triangulation of a polygon is the one whose least height
is greatest. It is found by dynamic programming over the diagonals (Klincsek 1980): the best value of the part cut off
by the diagonal i j is the greatest, over the triangles i k j, of the least of the triangle's height and of the best
values beyond i k and k j. O(n^3) triangles.
"""

from collections.abc import Callable
from math import inf

import numpy as np
from gmpy2 import lcm, mpq
from numpy.typing import NDArray

from exactmesh.errors import InputError
from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.filtered import FilteredPoints
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Mesh

MAX_OPTIMAL_VERTICES = 200
Signs = NDArray[np.int8]
Triangle = tuple[int, int, int]
Height = tuple[float, Triangle | None]


def classic_mesh(subdivision: Subdivision) -> Mesh:
    """Return the constrained Delaunay triangulation of the domain as a mesh of kind "classic"."""
    return Mesh("classic", subdivision.pslg.vertices, constrained_delaunay(subdivision).triangles)


def optimal_classic_mesh(subdivision: Subdivision, progress: Callable[[str], None] = lambda step: None) -> Mesh:
    """Return a classic mesh of one simple polygon with the greatest mfs that a classic mesh of it can have.

    Among the best triangles on a diagonal, that with the first vertex along the polygon is taken; the parts beyond
    its sides have the greatest least heights in turn. `progress` is told the name of each step. Raises `InputError`
    when the domain is not one simple polygon of at most `MAX_OPTIMAL_VERTICES` vertices.
    """
    ring = _simple_ring(subdivision)
    points = [subdivision.pslg.vertices[v] for v in ring]
    progress("visibility")
    visible = visible_pairs(points)
    progress("diagonals")
    triangles = _best_triangles(points, visible)
    faces = []
    for i, j, k in triangles:
        face = ring[i], ring[j], ring[k]
        first = face.index(min(face))
        faces.append(face[first:] + face[:first])
    return Mesh("classic", subdivision.pslg.vertices, tuple(sorted(faces)))


def _simple_ring(subdivision: Subdivision) -> list[int]:
    """Return the vertices of the domain, one simple polygon, counter-clockwise from the least."""
    domain = subdivision.domain
    walk = domain[0].outer if domain else None
    ring = [subdivision.half_edges.origin[h] for h in walk or ()]
    if len(domain) != 1 or domain[0].inner or domain[0].isolated or len(set(ring)) < len(ring):
        raise InputError("an optimal classic mesh is found for one simple polygon; this domain has several faces, "
                         "holes, dangling edges or isolated vertices")
    if len(ring) > MAX_OPTIMAL_VERTICES:
        raise InputError(f"an optimal classic mesh is found for at most {MAX_OPTIMAL_VERTICES} vertices, "
                         f"not {len(ring)}")
    start = ring.index(min(ring))
    return ring[start:] + ring[:start]


def visible_pairs(points: list[Point]) -> NDArray[np.bool_]:
    """Return, for all i and j, whether i j is an edge or an admissible diagonal of a counter-clockwise polygon.

    The open segment of a diagonal lies in the interior; it contains no vertex.
    """
    count = len(points)
    turn = _turns(points)
    after = np.roll(np.arange(count), -1)
    sides = turn[np.arange(count), after]
    rank = np.empty(count, dtype=np.int64)
    rank[sorted(range(count), key=points.__getitem__)] = np.arange(count)
    visible = np.zeros((count, count), dtype=np.bool_)
    for i in range(count):
        before, following = (i - 1) % count, (i + 1) % count
        visible[i, following] = visible[following, i] = True
        # Directions into the polygon at i; an angle of 180 degrees counts as convex.
        left_of_next, left_of_last = turn[i, following] > 0, turn[before, i] > 0
        convex = turn[before, i, following] >= 0
        inward = left_of_next & left_of_last if convex else left_of_next | left_of_last
        for j in np.flatnonzero(inward[i + 2 :]) + i + 2:
            sign = turn[i, j]
            crossed = (sign * sign[after] < 0) & (sides[:, i] * sides[:, j] < 0)
            low, high = sorted((rank[i], rank[j]))
            blocked = (sign == 0) & (low < rank) & (rank < high)
            if j != before and not crossed.any() and not blocked.any():
                visible[i, j] = visible[j, i] = True
    return visible


def _turns(points: list[Point]) -> Signs:
    """Return the orientations of all triples of points."""
    count = len(points)
    orientation = FilteredPoints(points).orientation
    turn = np.zeros((count, count, count), dtype=np.int8)
    for i in range(count):
        for j in range(i + 1, count):
            row = [orientation(i, j, k) for k in range(j + 1, count)]
            turn[i, j, j + 1 :] = row
    # Cyclic shifts keep the sign, exchanges turn it; where i < j < k does not hold, only one term is not zero.
    cyclic = turn + turn.transpose(1, 2, 0) + turn.transpose(2, 0, 1)
    signs: Signs = cyclic - cyclic.transpose(1, 0, 2)
    return signs


class _Heights:
    """Least heights of triangles, as (rounded square, triangle); (infinity, None) stands for no triangle.

    Rounding is monotone, for Python divides integers with correct rounding: of two unequal rounded squares the lesser
    has the lesser height. Only triangles with equal ones are compared exactly.
    """

    def __init__(self, points: list[Point]) -> None:
        self.points = points
        count = len(points)
        self.weights = [int(lcm(p.x.denominator, p.y.denominator)) for p in points]
        self.xs = [int(p.x * w) for p, w in zip(points, self.weights, strict=True)]
        self.ys = [int(p.y * w) for p, w in zip(points, self.weights, strict=True)]
        self.squares = [[distance_squared(p, q) for q in points] for p in points]
        diameter = max(max(row) for row in self.squares)
        # A power of two brings the diameter's square near 1, so that quotients neither overflow nor all vanish.
        shift = diameter.denominator.bit_length() - diameter.numerator.bit_length()
        up, down = max(shift, 0), max(-shift, 0)
        self.over = [[int(square.denominator) << up for square in row] for row in self.squares]
        self.under = [[int(square.numerator) << down for square in row] for row in self.squares]
        place = {square: r for r, square in enumerate(sorted({q for row in self.squares for q in row}))}
        self.rank = [[place[square] for square in row] for row in self.squares]
        self.lines = [[self._line(i, j) for j in range(count)] for i in range(count)]
        self.known: dict[Triangle, mpq] = {}

    def _line(self, i: int, j: int) -> tuple[int, int, int]:
        """Return the coefficients by which x, y, w of a third vertex give twice the area, times all three weights."""
        x, y, w = self.xs, self.ys, self.weights
        return y[i] * w[j] - w[i] * y[j], w[i] * x[j] - x[i] * w[j], x[i] * y[j] - y[i] * x[j]

    def height(self, i: int, k: int, j: int) -> Height:
        """Return the least height of the triangle i k j."""
        a, b, c = self.lines[i][j]
        weight = self.weights[k]
        area = a * self.xs[k] + b * self.ys[k] + c * weight
        rank = self.rank
        u, v = (i, j) if rank[i][j] >= rank[i][k] else (i, k)
        if rank[k][j] > rank[u][v]:
            u, v = k, j
        weight *= self.weights[i] * self.weights[j]
        return area * area * self.over[u][v] / (weight * weight * self.under[u][v]), (i, k, j)

    def is_less(self, a: Height, b: Height) -> bool:
        """Return whether the height a is less than b, exactly."""
        if a[0] != b[0] or a[1] is None or b[1] is None or a[1] == b[1]:
            return a[0] < b[0]
        return bool(self._exact(a[1]) < self._exact(b[1]))

    def _exact(self, triangle: Triangle) -> mpq:
        if triangle not in self.known:
            i, k, j = triangle
            area = doubled_area(self.points[i], self.points[k], self.points[j])
            squares = self.squares
            self.known[triangle] = area * area / max(squares[i][k], squares[k][j], squares[i][j])
        return self.known[triangle]


def _best_triangles(points: list[Point], visible: NDArray[np.bool_]) -> list[Triangle]:
    """Return the triangles of the triangulation with the greatest least height."""
    count = len(points)
    heights = _Heights(points)
    height, is_less = heights.height, heights.is_less
    none: Height = inf, None
    # best[i][j] is the least height of the best triangulation of the polygon i, i + 1, .., j; third[i][j] its vertex
    # at the side i j.
    best = [[none] * count for _ in range(count)]
    third = [[0] * count for _ in range(count)]
    for length in range(2, count):
        for i in range(count - length):
            j = i + length
            if not visible[i, j]:
                continue
            greatest: Height = -1.0, None
            for k in (np.flatnonzero(visible[i, i + 1 : j] & visible[i + 1 : j, j]) + i + 1).tolist():
                low, other = best[i][k], best[k][j]
                # What is clearly too low need not be measured.
                if low[0] < greatest[0] or other[0] < greatest[0]:
                    continue
                for value in (other, height(i, k, j)):
                    if is_less(value, low):
                        low = value
                if is_less(greatest, low):
                    greatest, third[i][j] = low, k
            best[i][j] = greatest
    return chosen_triangles(third)


def chosen_triangles(third: list[list[int]]) -> list[Triangle]:
    """Return the triangles of a polygon of n corners, from the side (0, n - 1) on: `third[i][j]` is the third corner of
    that on (i, j)."""
    triangles = []
    pending = [(0, len(third) - 1)]
    while pending:
        i, j = pending.pop()
        if j > i + 1:
            k = third[i][j]
            triangles.append((i, k, j))
            pending += [(i, k), (k, j)]
    return triangles
