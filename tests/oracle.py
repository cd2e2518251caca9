"""Brute-force answers straight from the definitions, sharing no code with `exactmesh`: standard library only.

Points are pairs of rationals (int, Fraction, anything with an integral numerator and denominator, or text),
edges are pairs of point indices, faces are cycles of them. Nothing is rounded and nothing is clever:
every pair is looked at. Meant for about 60 input vertices and 600 faces. Lengths are squared, areas exact.

mfs_squared           least squared distance of a vertex from a vertex or edge that does not contain it
degradation_squared   mfs_squared of the input over that of the mesh
domain_area           area of the bounded faces less the faces that contain a hole point
check_mesh            every clause of what a mesh is; returns the violations in words
read_pslg, read_mesh  the exchange formats `exactmesh-pslg/1` and `exactmesh-mesh/1`

Inside, a point is a triple of integers (X, Y, W), W > 0, that stands for (X/W, Y/W).
"""

import json
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any, TypeAlias

Pair: TypeAlias = Sequence[Any]
Edge: TypeAlias = Sequence[int]
Face: TypeAlias = Sequence[int]
Place: TypeAlias = tuple[Fraction, Fraction]
Triple: TypeAlias = tuple[int, int, int]
Cell: TypeAlias = tuple[int, int]

KINDS = ("classic", "nonproper", "proper", "internal")


# --- numbers and points ---


def exact(value: Any) -> Fraction:
    """Return a rational given as a number or as text."""
    if isinstance(value, str):
        return Fraction(value)
    return Fraction(int(value.numerator), int(value.denominator))


def place(p: Pair) -> Place:
    """Return a point as two Fractions."""
    x, y = p
    return exact(x), exact(y)


def triple(p: Pair) -> Triple:
    """Return a point as (X, Y, W), W > 0."""
    x, y = place(p)
    return x.numerator * y.denominator, y.numerator * x.denominator, x.denominator * y.denominator


def turn(a: Triple, b: Triple, c: Triple) -> int:
    """Return 1, 0 or -1 as a, b, c turn left, are collinear or turn right: the sign of a determinant."""
    value = (a[0] * (b[1] * c[2] - c[1] * b[2]) - a[1] * (b[0] * c[2] - c[0] * b[2])
             + a[2] * (b[0] * c[1] - c[0] * b[1]))
    return (value > 0) - (value < 0)


def _difference(p: Triple, q: Triple) -> tuple[int, int]:
    """Return p - q times the positive number Wp Wq."""
    return p[0] * q[2] - q[0] * p[2], p[1] * q[2] - q[1] * p[2]


def on_segment(p: Triple, a: Triple, b: Triple) -> bool:
    """Return whether p lies on the segment ab, its ends included."""
    if turn(a, b, p):
        return False
    (ux, uy), (vx, vy) = _difference(p, a), _difference(p, b)
    return ux * vx + uy * vy <= 0


def meet(a: Triple, b: Triple, c: Triple, d: Triple) -> bool:
    """Return whether the segments ab and cd have a common point."""
    if on_segment(a, c, d) or on_segment(b, c, d) or on_segment(c, a, b) or on_segment(d, a, b):
        return True
    return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0


# --- minimum feature size ---


def mfs_squared(points: Sequence[Pair], edges: Iterable[Edge]) -> Fraction | None:
    """Return the least squared distance of a vertex from a vertex or an edge that does not contain it.

    None when there is no such pair. A place contains itself, an edge all of its points.
    """
    at = [triple(p) for p in points]
    best: tuple[int, int] | None = None
    for p, q in combinations(at, 2):
        dx, dy = _difference(p, q)
        square, unit = dx * dx + dy * dy, (p[2] * q[2]) ** 2
        if square and (best is None or square * best[1] < best[0] * unit):
            best = square, unit
    for u, v in edges:
        a, b = at[u], at[v]
        ex, ey = _difference(b, a)
        length = ex * ex + ey * ey
        for p in at:
            px, py = _difference(p, a)
            qx, qy = _difference(p, b)
            # Nearest to an end, the distance is one between vertices, seen above.
            if px * ex + py * ey > 0 > qx * ex + qy * ey:
                area = px * ey - py * ex
                square, unit = area * area, length * (p[2] * a[2]) ** 2
                if square and (best is None or square * best[1] < best[0] * unit):
                    best = square, unit
    return None if best is None else Fraction(*best)


def mesh_edges(faces: Iterable[Face], edges: Iterable[Edge]) -> set[tuple[int, int]]:
    """Return the edges of a mesh, lower index first: consecutive pairs of faces, and the input's edges."""
    found = {(min(e), max(e)) for e in edges}
    for face in faces:
        found |= {(min(e), max(e)) for e in _sides(face)}
    return found


def _sides(face: Face) -> list[tuple[int, int]]:
    """Return the directed edges of a cycle."""
    return [(face[i - 1], face[i]) for i in range(len(face))]


def degradation_squared(points: Sequence[Pair], edges: Sequence[Edge], mesh_points: Sequence[Pair],
                        faces: Sequence[Face]) -> Fraction | None:
    """Return mfs_squared of the input over mfs_squared of the mesh; None when either has no pair."""
    before = mfs_squared(points, edges)
    after = mfs_squared(mesh_points, mesh_edges(faces, edges))
    return None if before is None or after is None else before / after


# --- the domain ---


class Domain:
    """The plane cut into cells: horizontal slabs between all vertex ordinates, cut again by the edges.

    Cell (i, k) lies in slab i, between its edges k - 1 and k counted from the left. Cells that touch along a
    level where no horizontal edge lies between them belong to one face. `OUTSIDE` stands for all above and
    below. The input must be a valid PSLG. Raises `ValueError` for a hole point on an edge or in the unbounded
    face.
    """

    OUTSIDE: Cell = (-1, 0)

    def __init__(self, points: Sequence[Pair], edges: Iterable[Edge], holes: Iterable[Pair] = ()) -> None:
        self.points = [place(p) for p in points]
        self.edges = [(self.points[u], self.points[v]) for u, v in edges]
        self.levels = sorted({y for _, y in self.points})
        self.slabs = [self._slab(low, high) for low, high in pairwise(self.levels)]
        self.parent: dict[Cell, Cell] = {self.OUTSIDE: self.OUTSIDE}
        for i, slab in enumerate(self.slabs):
            self.parent |= {(i, k): (i, k) for k in range(len(slab) + 1)}
        for j in range(len(self.levels)):
            self._join(j)
        self.empty = {self.root(self.OUTSIDE)}
        for hole in holes:
            face = self.locate(hole)
            if face is None or face == self.root(self.OUTSIDE):
                raise ValueError(f"hole point {hole} does not lie in a bounded face")
            self.empty.add(face)

    def _slab(self, low: Fraction, high: Fraction) -> list[tuple[Place, Place]]:
        """Return the edges that cross the slab, from left to right."""
        middle = (low + high) / 2
        crossing = [e for e in self.edges if min(e[0][1], e[1][1]) < middle < max(e[0][1], e[1][1])]
        return sorted(crossing, key=lambda e: _abscissa(e, middle))

    def _join(self, j: int) -> None:
        """Unite the cells below and above level j that touch along an open piece of it."""
        y = self.levels[j]
        below, above = self._crossings(j - 1, y), self._crossings(j, y)
        flat = [sorted((a[0], b[0])) for a, b in self.edges if a[1] == b[1] == y]
        breaks = sorted({*below, *above, *(x for x, h in self.points if h == y)})
        samples = [breaks[0] - 1, *((a + b) / 2 for a, b in pairwise(breaks)), breaks[-1] + 1]
        for x in samples:
            if not any(a < x < b for a, b in flat):
                lower, upper = self.root(self._cell(j - 1, below, x)), self.root(self._cell(j, above, x))
                self.parent[lower] = upper

    def _crossings(self, i: int, y: Fraction) -> list[Fraction]:
        """Return the abscissas at which the edges of slab i meet the ordinate y, one of its own or within."""
        return [_abscissa(e, y) for e in self.slabs[i]] if 0 <= i < len(self.slabs) else []

    def _cell(self, i: int, crossings: list[Fraction], x: Fraction) -> Cell:
        return (i, bisect_left(crossings, x)) if 0 <= i < len(self.slabs) else self.OUTSIDE

    def root(self, cell: Cell) -> Cell:
        """Return the cell that stands for the face of `cell`."""
        while self.parent[cell] != cell:
            cell = self.parent[cell]
        return cell

    def locate(self, p: Pair) -> Cell | None:
        """Return the cell that stands for the face around p; None when p lies on an edge or a vertex."""
        x, y = place(p)
        at = triple((x, y))
        if (x, y) in self.points or any(on_segment(at, triple(a), triple(b)) for a, b in self.edges):
            return None
        # Slab i has levels[i] <= y < levels[i + 1]; a point on a level lies in the face directly above it.
        i = sum(level <= y for level in self.levels) - 1
        return self.root(self._cell(i, self._crossings(i, y), x))

    def contains(self, p: Pair) -> bool:
        """Return whether p lies in the interior of a face of the domain."""
        face = self.locate(p)
        return face is not None and face not in self.empty

    def area(self) -> Fraction:
        """Return the area of all faces of the domain."""
        total = Fraction(0)
        for i, (low, high) in enumerate(pairwise(self.levels)):
            for k, (left, right) in enumerate(pairwise(self.slabs[i]), 1):
                if self.root((i, k)) not in self.empty:
                    widths = [_abscissa(right, y) - _abscissa(left, y) for y in (low, high)]
                    total += sum(widths) * (high - low) / 2
        return total


def _abscissa(edge: tuple[Place, Place], y: Fraction) -> Fraction:
    """Return x where the line of an edge that is not horizontal has ordinate y."""
    (ax, ay), (bx, by) = edge
    return ax + (bx - ax) * (y - ay) / (by - ay)


def domain_area(points: Sequence[Pair], edges: Iterable[Edge], holes: Iterable[Pair] = ()) -> Fraction:
    """Return the area of the bounded faces, less the faces that contain a hole point."""
    return Domain(points, edges, holes).area()


def polygon_area(corners: Sequence[Pair]) -> Fraction:
    """Return the signed area of one polygon by the shoelace formula, positive when counter-clockwise."""
    at = [place(p) for p in corners]
    doubled = sum((at[i - 1][0] * q[1] - at[i - 1][1] * q[0] for i, q in enumerate(at)), Fraction(0))
    return doubled / 2


# --- meshes ---


def check_mesh(points: Sequence[Pair], edges: Sequence[Edge], holes: Sequence[Pair],
               mesh_points: Sequence[Pair], faces: Sequence[Face], kind: str) -> list[str]:
    """Return what is wrong with a mesh of the PSLG (points, edges, holes), in words; [] when nothing is.

    The PSLG itself must be valid. Clauses, where a later group is looked at only when the earlier ones hold:
      1  the kind is known; the input's vertices come first and are the same; faces are cycles of three or
         more distinct indices in range; no two vertices coincide
      2  every face turns left at exactly three vertices, its corners, and goes straight on at the others;
         classic, proper and internal faces have three vertices; a classic mesh has no Steiner vertex
      3  a vertex on the boundary of a face is listed in it; no vertex lies inside a face; an edge has at most
         one face on either side; no two edges have more in common than a common end; no vertex lies in the
         interior of an input edge, unless the kind is internal; an input edge (internal: each piece of it)
         that lies in a face is an edge of a face; two faces have no interior point in common; every face lies
         in the domain; the areas of the faces add up to the area of the domain; every Steiner vertex is in a
         face
    """
    found = _structure(points, edges, mesh_points, faces, kind)
    if not found:
        mesh = _Mesh(mesh_points, faces)
        found = mesh.shapes(len(points), kind)
        if not found:
            found = [*mesh.vertices_and_faces(), *mesh.sides(), *mesh.input_edges(edges, kind),
                     *mesh.overlaps(), *mesh.cover(Domain(points, edges, holes)), *mesh.unused(len(points))]
    return found


def _structure(points: Sequence[Pair], edges: Sequence[Edge], mesh_points: Sequence[Pair],
               faces: Sequence[Face], kind: str) -> list[str]:
    found = [] if kind in KINDS else [f"unknown kind {kind!r}"]
    if len(mesh_points) < len(points):
        found.append(f"the mesh has {len(mesh_points)} vertices, fewer than the input's {len(points)}")
    for i, (p, q) in enumerate(zip(points, mesh_points, strict=False)):
        if place(p) != place(q):
            found.append(f"input vertex {i} has moved from {p} to {q}")
    for f, face in enumerate(faces):
        if not all(0 <= v < len(mesh_points) for v in face):
            found.append(f"face {f} {tuple(face)} has an index out of range")
        elif len(face) < 3 or len(set(face)) < len(face):
            found.append(f"face {f} {tuple(face)} is not a cycle of three or more distinct vertices")
    first: dict[Place, int] = {}
    for i, p in enumerate(mesh_points):
        other = first.setdefault(place(p), i)
        if other != i:
            found.append(f"vertices {other} and {i} coincide")
    return found


class _Mesh:
    """A mesh with sound structure. Boxes are of ranks: a coordinate's place in the sorted list of all."""

    def __init__(self, points: Sequence[Pair], faces: Sequence[Face]) -> None:
        self.places = [place(p) for p in points]
        self.at = [triple(p) for p in points]
        self.faces = [tuple(face) for face in faces]
        self.corners = [tuple(face[i] for i in range(len(face)) if self._turn(face, i) > 0) for face in faces]
        ranks = []
        for axis in (0, 1):
            rank = {value: r for r, value in enumerate(sorted({p[axis] for p in self.places}))}
            ranks.append([rank[p[axis]] for p in self.places])
        self.rank = list(zip(*ranks, strict=True))

    def _turn(self, face: Face, i: int) -> int:
        return turn(self.at[face[i - 1]], self.at[face[i]], self.at[face[(i + 1) % len(face)]])

    def _box(self, vertices: Iterable[int]) -> tuple[int, int, int, int]:
        xs, ys = zip(*(self.rank[v] for v in vertices), strict=True)
        return min(xs), max(xs), min(ys), max(ys)

    def shapes(self, input_count: int, kind: str) -> list[str]:
        """Check group 2."""
        found = []
        if kind == "classic" and len(self.at) > input_count:
            found.append("a classic mesh has no Steiner vertices")
        for f, face in enumerate(self.faces):
            named = f"face {f} {face}"
            if kind != "nonproper" and len(face) != 3:
                found.append(f"{named} of a {kind} mesh has {len(face)} vertices, not 3")
            turns = [self._turn(face, i) for i in range(len(face))]
            # At a straight vertex the way goes on: the vertex lies between its neighbours.
            ways = [[self.at[face[(i + step) % len(face)]] for step in (0, -1, 1)] for i in range(len(face))]
            onward = all(on_segment(*way) for way, sign in zip(ways, turns, strict=True) if sign == 0)
            # Three left turns, each below 180 degrees, add up to one full turn: the cycle is a triangle.
            if min(turns) < 0 or turns.count(1) != 3 or not onward:
                found.append(f"{named} is not a counter-clockwise triangle")
        return found

    def _sides_of(self, p: Triple, f: int) -> list[int]:
        """Return on which side of each of its sides' lines, counter-clockwise, the triangle f has p."""
        a, b, c = (self.at[v] for v in self.corners[f])
        return [turn(a, b, p), turn(b, c, p), turn(c, a, p)]

    def vertices_and_faces(self) -> list[str]:
        """Check every vertex against every face."""
        found = []
        for f, face in enumerate(self.faces):
            left, right, low, high = self._box(face)
            for v, (x, y) in enumerate(self.rank):
                if left <= x <= right and low <= y <= high and v not in face:
                    least = min(self._sides_of(self.at[v], f))
                    if least > 0:
                        found.append(f"vertex {v} lies inside face {f} {face}")
                    elif least == 0:
                        found.append(f"vertex {v} lies on a side of face {f} {face}, which leaves it out")
        return found

    def sides(self) -> list[str]:
        """Check that no directed edge belongs to two faces."""
        count = Counter(side for face in self.faces for side in _sides(face))
        return [f"edge {side} has {number} faces on one side" for side, number in count.items() if number > 1]

    def input_edges(self, edges: Sequence[Edge], kind: str) -> list[str]:
        """Check the input's edges against vertices and faces, and all edges against each other."""
        found = []
        in_faces = mesh_edges(self.faces, ())
        pieces: set[tuple[int, int]] = set()
        for e, (u, v) in enumerate(edges):
            a, b = self.at[u], self.at[v]
            inside = [w for w, p in enumerate(self.at) if w not in (u, v) and on_segment(p, a, b)]
            if kind == "internal":
                chain = sorted((u, v, *inside), key=lambda w: self.places[w])
                pieces |= {(min(piece), max(piece)) for piece in pairwise(chain)}
            else:
                found += [f"vertex {w} lies in the interior of input edge {e} ({u}, {v})" for w in inside]
                pieces.add((min(u, v), max(u, v)))
        for u, v in sorted(pieces - in_faces):
            (ax, ay, aw), (bx, by, bw) = self.at[u], self.at[v]
            middle = (ax * bw + bx * aw, ay * bw + by * aw, 2 * aw * bw)
            for f in range(len(self.faces)):
                if min(self._sides_of(middle, f)) >= 0:
                    found.append(f"input edge ({u}, {v}) is no side of a face but runs through face {f}")
        return found + self._crossings(sorted(in_faces | pieces))

    def _crossings(self, edges: Sequence[tuple[int, int]]) -> list[str]:
        found = []
        boxed = [(e, self._box(e)) for e in edges]
        for (e, (left, right, low, high)), (f, (left2, right2, low2, high2)) in combinations(boxed, 2):
            if left2 <= right and left <= right2 and low2 <= high and low <= high2 and self._clash(e, f):
                found.append(f"edges {e} and {f} have more than an end in common")
        return found

    def _clash(self, e: tuple[int, int], f: tuple[int, int]) -> bool:
        shared = set(e) & set(f)
        if not shared:
            return meet(self.at[e[0]], self.at[e[1]], self.at[f[0]], self.at[f[1]])
        v = shared.pop()
        p, q = (self.at[w] for w in (*e, *f) if w != v)
        return on_segment(p, self.at[v], q) or on_segment(q, self.at[v], p)

    def overlaps(self) -> list[str]:
        """Check all pairs of faces: two triangles are disjoint inside iff a side of one separates them."""
        found = []
        boxes = [self._box(face) for face in self.faces]
        for f, g in combinations(range(len(self.faces)), 2):
            left, right, low, high = boxes[f]
            left2, right2, low2, high2 = boxes[g]
            apart = left2 >= right or left >= right2 or low2 >= high or low >= high2
            if not apart and not self._separated(f, g) and not self._separated(g, f):
                found.append(f"faces {f} {self.faces[f]} and {g} {self.faces[g]} overlap")
        return found

    def _separated(self, f: int, g: int) -> bool:
        """Return whether some side of f has the triangle g on its outer side."""
        outer = [self._sides_of(self.at[v], f) for v in self.corners[g]]
        return any(max(signs) <= 0 for signs in zip(*outer, strict=True))

    def cover(self, domain: Domain) -> list[str]:
        """Check that the faces lie in the domain and have its area."""
        found = []
        total = Fraction(0)
        for f, (face, corners) in enumerate(zip(self.faces, self.corners, strict=True)):
            at = [self.places[v] for v in corners]
            total += polygon_area(at)
            if not domain.contains((sum(p[0] for p in at) / 3, sum(p[1] for p in at) / 3)):
                found.append(f"face {f} {face} does not lie in the domain")
        if total != domain.area():
            found.append(f"the faces have area {total}, the domain has {domain.area()}")
        return found

    def unused(self, input_count: int) -> list[str]:
        """Check that every Steiner vertex is in a face."""
        used = {v for face in self.faces for v in face}
        steiner = range(input_count, len(self.at))
        return [f"Steiner vertex {v} is in no face" for v in steiner if v not in used]


# --- files ---


def read_pslg(text: str) -> tuple[list[Place], list[tuple[int, int]], list[Place]]:
    """Return points, edges and hole points of an `exactmesh-pslg/1` document.

    Scalars must be text or integers: doubles are not read.
    """
    data = json.loads(text)
    if data["format"] != "exactmesh-pslg/1":
        raise ValueError(f"not a PSLG: {data['format']!r}")
    edges = [(int(u), int(v)) for u, v in data["edges"]]
    return [place(p) for p in data["vertices"]], edges, [place(p) for p in data.get("holes", [])]


def read_mesh(text: str) -> tuple[list[Place], list[tuple[int, ...]], str]:
    """Return points, faces and kind of an `exactmesh-mesh/1` document."""
    data = json.loads(text)
    if data["format"] != "exactmesh-mesh/1":
        raise ValueError(f"not a mesh: {data['format']!r}")
    faces = [tuple(map(int, face)) for face in data["faces"]]
    return [place(p) for p in data["vertices"]], faces, data["kind"]
