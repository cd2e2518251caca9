"""Domains that are no simple polygons, mostly random: maps, holes, nested rings, trees, isolated points, thin walls."""

import math
import random
from collections.abc import Sequence
from fractions import Fraction

from gmpy2 import mpq

from exactmesh.families.build import Builder, Lattice, Number, Pair, cycle, near_circle, place, turn
from exactmesh.families.changes import with_collinear_vertices
from exactmesh.families.random_polygons import star_shaped
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import subdivide
from exactmesh.planar.pslg import Edge, Pslg


def grid_map(columns: int, rows: int, seed: int, keep: Fraction = Fraction(3, 4)) -> Pslg:
    """Return a map of columns x rows cells, corners moved at random by less than 1/4.

    An inner edge is kept with probability `keep`, so countries merge, and dangling edges and isolated points
    appear; the border is whole. (columns + 1)(rows + 1) vertices, coordinates in thousandths.
    """
    source = random.Random(f"map {columns} {rows} {seed}")
    points = [(i + Fraction(source.randint(-240, 240), 1000), j + Fraction(source.randint(-240, 240), 1000))
              for j in range(rows + 1) for i in range(columns + 1)]
    width = columns + 1
    edges: list[Edge] = []
    for j in range(rows + 1):
        for i in range(columns + 1):
            at = j * width + i
            if i < columns and (j in (0, rows) or source.random() < keep):
                edges.append((at, at + 1))
            if j < rows and (i in (0, columns) or source.random() < keep):
                edges.append((at, at + width))
    builder = Builder()
    builder.add(points, edges)
    return builder.pslg(f"map {columns} x {rows}, seed {seed}")


def random_pslg(seed: int, cells: int = 3) -> Pslg:
    """Return a rectangle of cells x cells cells of side 10, each with one random feature well inside.

    The features: nothing; a hole (a star-shaped ring, marked by a hole point); a ring that is not a hole;
    three nested rings, at random with a hole point between the first two; a tree of edges; one to four
    isolated points; a small map; a single edge. At random a triangle lies to the right, and a tree outside,
    to the left. About 5 vertices a cell.
    """
    source = random.Random(f"pslg {cells} {seed}")
    builder = Builder()
    side = 10 * cells
    builder.add([(0, 0), (side, 0), (side, side), (0, side)], cycle(4))
    for column in range(cells):
        for row in range(cells):
            source.choice(_FEATURES)(builder, (10 * column + 5, 10 * row + 5), source)
    if source.random() < 0.5:
        builder.add([(side + 2, 0), (side + 9, 1), (side + 5, 8)], cycle(3))
    if source.random() < 0.5:
        _tree(builder, (-6, 5), source)
    return builder.pslg(f"random pslg of {cells} x {cells} cells, seed {seed}")


def _small_ring(size: int, source: random.Random) -> list[Lattice]:
    return star_shaped(source.randint(4, size), source)


def _ring_of(builder: Builder, at: Pair, radius: Number, source: random.Random) -> None:
    """Add a star-shaped ring with every vertex within max-norm `radius` of `at`."""
    corners = _small_ring(9, source)
    largest = max(max(abs(x), abs(y)) for x, y in corners)
    builder.add(corners, cycle(len(corners)), at, mpq(radius) / largest)


def _nothing(builder: Builder, at: Lattice, source: random.Random) -> None:
    """Leave a cell empty."""


def _hole(builder: Builder, at: Lattice, source: random.Random) -> None:
    _ring_of(builder, at, 4, source)
    builder.holes.append(place((0, 0), at, 1))


def _island(builder: Builder, at: Lattice, source: random.Random) -> None:
    _ring_of(builder, at, 4, source)


def _nested(builder: Builder, at: Lattice, source: random.Random) -> None:
    # Squares on their corners, turned: each fits into the disc in the one before.
    for half in (40, 25, 15):
        turn = source.randint(-9, 9)
        corners = [(half, turn), (-turn, half), (-half, -turn), (turn, -half)]
        builder.add(corners, cycle(4), at, Fraction(1, 10))
    if source.random() < 0.5:
        outer, inner = builder.vertices[-12], builder.vertices[-8]
        builder.holes.append(Point((outer.x + inner.x) / 2, (outer.y + inner.y) / 2))


def _tree(builder: Builder, at: Lattice, source: random.Random) -> None:
    """Add a random tree of 3 to 9 nodes on a moved 3 x 3 grid of unit 2."""
    nodes: list[Lattice] = [(0, 0)]
    edges: list[Edge] = []
    size = source.randint(3, 9)
    while len(nodes) < size:
        parent = source.randrange(len(nodes))
        dx, dy = source.choice(((1, 0), (-1, 0), (0, 1), (0, -1)))
        child = (nodes[parent][0] + dx, nodes[parent][1] + dy)
        if child not in nodes and max(map(abs, child)) <= 1:
            edges.append((parent, len(nodes)))
            nodes.append(child)
    moved = [(1000 * x + source.randint(-240, 240), 1000 * y + source.randint(-240, 240)) for x, y in nodes]
    builder.add(moved, edges, at, Fraction(2, 1000))


def _points(builder: Builder, at: Lattice, source: random.Random) -> None:
    places = source.sample([(x, y) for x in range(-3, 4) for y in range(-3, 4)], source.randint(1, 4))
    builder.add(places, [], at)


def _small_map(builder: Builder, at: Lattice, source: random.Random) -> None:
    inner = grid_map(2, 2, source.randrange(10**6))
    builder.add([(p.x - 1, p.y - 1) for p in inner.vertices], inner.edges, at, 2)


def _single_edge(builder: Builder, at: Lattice, source: random.Random) -> None:
    ends = [(sign * source.randint(1, 4), source.randint(-4, 4)) for sign in (-1, 1)]
    builder.add(ends, [(0, 1)], at)


_FEATURES = (_nothing, _hole, _island, _nested, _tree, _points, _small_map, _single_edge)


def nested_rings(depth: int, seed: int = 0, marked: bool = False) -> Pslg:
    """Return `depth` nested squares, turned at random, about 1 apart; when `marked` every second gap is a hole."""
    source = random.Random(f"nested {depth} {seed}")
    builder = Builder()
    for i in range(depth):
        # A square of half diagonal h, slightly turned, lies between the circles of radius 0.7 h and 1.03 h.
        half = mpq(100 * 160**i, 100**i)
        turn = half * Fraction(source.randint(-200, 200), 1000)
        builder.add([(half, turn), (-turn, half), (-half, -turn), (turn, -half)], cycle(4))
        if marked and i % 2:
            builder.holes.append(place((half, turn), (0, 0), mpq(96, 100)))
    return builder.pslg(f"{depth} nested rings, seed {seed}")


def polygon_with_holes(columns: int, rows: int, seed: int, marked: bool = True) -> Pslg:
    """Return a rectangle with columns x rows star-shaped rings of 4 to 9 vertices in it, holes when `marked`."""
    source = random.Random(f"holes {columns} {rows} {seed}")
    builder = Builder()
    builder.add([(0, 0), (10 * columns, 0), (10 * columns, 10 * rows), (0, 10 * rows)], cycle(4))
    for column in range(columns):
        for row in range(rows):
            _ring_of(builder, (10 * column + 5, 10 * row + 5), Fraction(source.randint(5, 45), 10), source)
            if marked:
                builder.holes.append(place((0, 0), (10 * column + 5, 10 * row + 5), 1))
    return builder.pslg(f"{columns} x {rows} holes, seed {seed}")


def wheel(spokes: int, rim: bool = True) -> Pslg:
    """Return a vertex of degree `spokes`: joined to a rim, or with its spokes dangling in a square."""
    builder = Builder()
    circle = near_circle(spokes)
    builder.add([(0, 0), *circle], [(0, i + 1) for i in range(spokes)], unit=10)
    if rim:
        builder.edges += [(u + 1, v + 1) for u, v in cycle(spokes)]
    else:
        builder.add([(-15, -16), (17, -15), (15, 16), (-17, 15)], cycle(4))
    return builder.pslg(f"wheel of {spokes} spokes{'' if rim else ', no rim'}")


def boxed_tree(columns: int, rows: int, seed: int) -> Pslg:
    """Return a box with a random spanning tree of columns x rows moved grid points in it, hanging freely."""
    source = random.Random(f"tree {columns} {rows} {seed}")
    at = [(i + Fraction(source.randint(-240, 240), 1000), j + Fraction(source.randint(-240, 240), 1000))
          for j in range(rows) for i in range(columns)]
    steps = [(j * columns + i, j * columns + i + 1) for j in range(rows) for i in range(columns - 1)]
    steps += [(j * columns + i, (j + 1) * columns + i) for j in range(rows - 1) for i in range(columns)]
    source.shuffle(steps)
    root = list(range(columns * rows))
    tree: list[Edge] = []
    for u, v in steps:
        a, b = u, v
        while root[a] != a:
            a = root[a]
        while root[b] != b:
            b = root[b]
        if a != b:
            root[a] = b
            tree.append((u, v))
    builder = Builder()
    builder.add(at, tree)
    builder.add([(-2, -2), (columns + 1, -2), (columns + 1, rows + 1), (-2, rows + 1)], cycle(4))
    return builder.pslg(f"tree of {columns} x {rows} vertices, seed {seed}")


def random_segments(points: int, edges: int, seed: int, size: int = 0) -> Pslg:
    """Return a box with random lattice points, joined by up to `edges` random edges that meet at most at ends.

    Few edges leave most points isolated; many make a subdivision with edges at any angle. `size` is the side of the
    lattice, 100 times the number of points when left out: a small one makes many points collinear.
    """
    source = random.Random(f"segments {points} {edges} {seed} {size}")
    side = size or 100 * points
    chosen: dict[Lattice, None] = {}
    while len(chosen) < points:
        chosen[source.randint(1, side - 1), source.randint(1, side - 1)] = None
    at: list[Lattice] = [*chosen]
    kept: list[Edge] = []
    for _ in range(8 * edges):
        if len(kept) == edges:
            break
        u = source.randrange(points)
        near = sorted(range(points), key=lambda w, u=u: math.dist(at[u], at[w]))[1:12]  # type: ignore[misc]
        v = source.choice(near)
        if not any(_clash(at, (u, v), edge) for edge in kept) and not any(
                w not in (u, v) and _is_between(at[w], at[u], at[v]) for w in range(points)):
            kept.append((u, v))
    builder = Builder()
    builder.add(at, kept)
    builder.add([(0, 0), (side, 0), (side, side), (0, side)], cycle(4))
    return builder.pslg(f"{points} points, {edges} segments, seed {seed}")


def _is_between(p: Lattice, a: Lattice, b: Lattice) -> bool:
    return turn(a, b, p) == 0 and min(a, b) <= p <= max(a, b)


def _clash(at: Sequence[Lattice], e: Edge, f: Edge) -> bool:
    """Return whether two edges are the same or cross; that no vertex lies on an edge is tested elsewhere."""
    if set(e) & set(f):
        return set(e) == set(f)
    (a, b), (c, d) = ((at[u], at[v]) for u, v in (e, f))
    return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0


def thin_walls(pslg: Pslg, thickness: Number) -> Pslg:
    """Return the bounded faces of a PSLG drawn apart: every edge becomes a wall of about this thickness.

    Each corner of each face moves into its face by `thickness`, which must be far below the mfs; the walls are no part
    of the domain, so no edge has it on both sides, and the new ifs is about the old mfs while the mfs is about
    the thickness. Isolated vertices stay.
    """
    subdivision = subdivide(pslg)
    if any(len(walk) == 2 for face in subdivision.faces for walk in face.inner):
        # An edge that hangs freely has two corners only: a vertex in the middle makes its wall a quadrilateral.
        pslg = with_collinear_vertices(pslg, 1)
        subdivision = subdivide(pslg)
    origin = subdivision.half_edges.origin
    builder = Builder()
    builder.holes = list(pslg.holes)

    def angle(h: int) -> float:
        p, q = pslg.vertices[origin[h]], pslg.vertices[origin[h ^ 1]]
        size = max(abs(q.x - p.x), abs(q.y - p.y))
        return math.atan2(float((q.y - p.y) / size), float((q.x - p.x) / size))

    for face in subdivision.faces[1:]:
        for walk in face.walks:
            corners: list[Pair] = []
            for incoming, outgoing in zip((walk[-1], *walk[:-1]), walk, strict=True):
                p = pslg.vertices[origin[outgoing]]
                # The face lies counter-clockwise of the outgoing edge, up to the incoming one turned back.
                opening = (angle(incoming ^ 1) - angle(outgoing)) % (2 * math.pi) or 2 * math.pi
                middle = angle(outgoing) + opening / 2
                corners.append((p.x + Fraction(round(math.cos(middle) * 1000), 1000) * mpq(thickness),
                                p.y + Fraction(round(math.sin(middle) * 1000), 1000) * mpq(thickness)))
            builder.add(corners, cycle(len(corners)))
        builder.add([pslg.vertices[v] for v in face.isolated], [])
        builder.holes += [pslg.vertices[origin[walk[0]]] for walk in face.inner]
    return builder.pslg(f"{pslg.name}, walls of {thickness}")
