"""Exact inputs for tests: families of polygons and PSLGs that are known to be hard, and random ones.

Every function returns a `Pslg` with rational coordinates and depends on its arguments only: random families
take a seed. Polygons are listed counter-clockwise unless a docstring says otherwise. Nothing here validates
its result; `test_families.py` does.

Families       regular_polygon, rectangle_with_two_midway_vertices, comb, spike_room, l_shape,
               rectangular_spiral, curved_spiral, convex_spike, reflex_notch, sliver, star, staircase
Random         random_simple_polygon (kinds in KINDS), grid_map, random_pslg
Changes        scaled, translated, rotated, mirrored, reversed_orientation, with_start,
               with_collinear_vertices, big_coordinates
Domains        nested_rings, polygon_with_holes, wheel, boxed_tree, random_segments, spike_with_ledges, thin_walls,
               slits, walled_spiral, leaning_strip
Collections    ALL_SMALL, SMALL_PSLGS, issue_list
"""

import math
import random
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TypeAlias

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.faces import subdivide
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.steps.constants import LEVEL

Number: TypeAlias = int | Fraction | mpq
Pair: TypeAlias = tuple[Number, Number]
Lattice: TypeAlias = tuple[int, int]

SHARP = Fraction(1, 10**6)


def ring(corners: Iterable[Sequence[Number]], name: str = "") -> Pslg:
    """Return the polygon with these corners in order."""
    vertices = tuple(Point(mpq(x), mpq(y)) for x, y in corners)
    count = len(vertices)
    return Pslg(vertices, tuple((i, (i + 1) % count) for i in range(count)), name=name)


# --- families ---


def regular_polygon(n: int) -> Pslg:
    """Return n >= 3 rational points exactly on the unit circle, near the vertices of the regular n-gon.

    The angle is reduced to [-pi/4, pi/4] by exact quarter turns; there the point is
    ((1-t^2)/(1+t^2), 2t/(1+t^2)), with t the tangent of half the angle rounded to a multiple of 1/(64 n).
    Vertex 0 is (1, 0).
    """
    return ring(_near_circle(n), f"regular {n}-gon")


def _near_circle(n: int) -> list[Pair]:
    points: list[Pair] = []
    for i in range(n):
        quarter = round(4 * i / n)
        angle = 2 * math.pi * (4 * i - quarter * n) / (4 * n)
        t = Fraction(round(math.tan(angle / 2) * 64 * n), 64 * n)
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        for _ in range(quarter % 4):
            x, y = -y, x
        points.append((x, y))
    return points


def rectangle_with_two_midway_vertices(r: Number) -> Pslg:
    """Return the r x 1 rectangle, r > 1, with two vertices midway along its lower side, 1 apart (n = 6).

    Mitchell's example (Bern, Dobkin and Eppstein 1995): every classic triangulation degrades by about r/2.
    """
    middle = mpq(r) / 2
    half = mpq(1, 2)
    return ring([(0, 0), (middle - half, 0), (middle + half, 0), (r, 0), (r, 1), (0, 1)],
                f"rectangle {r} x 1 with two midway vertices")


def comb(teeth: int, floor: Number | None = None, spacing: str = "even", level_difference: Number = 0,
         depth: Number = 3) -> Pslg:
    """Return a room with one long floor and `teeth` >= 1 teeth that end at height 1 (n = 2 teeth + 3).

    The teeth hang from a ceiling at height 1 + `depth`. `floor` is the floor's length, 2 teeth + 2 when left
    out. The tips stand evenly ("even"), at gaps that repeat 1, 5, 2, 11 ("uneven") or at gaps that double
    ("doubling"), scaled to the floor. The tips lie at 1 plus a multiple 0, 3, 1, 4, 2, 0, ... of
    `level_difference`: 0 puts all on one level, 1e-6 on five nearly equal levels.
    """
    gaps = {"even": [1] * (teeth + 1),
            "uneven": [(1, 5, 2, 11)[i % 4] for i in range(teeth + 1)],
            "doubling": [2**i for i in range(teeth + 1)]}[spacing]
    length = mpq(2 * teeth + 2 if floor is None else floor)
    unit = length / sum(gaps)
    tips = [unit * sum(gaps[: i + 1]) for i in range(teeth)]
    top = 1 + mpq(depth)
    corners: list[Pair] = [(0, 0), (length, 0), (length, top)]
    for i in range(teeth - 1, -1, -1):
        corners.append((tips[i], 1 + mpq(level_difference) * (3 * i % 5)))
        corners.append(((tips[i] + tips[i - 1]) / 2 if i else 0, top))
    return ring(corners, f"comb of {teeth} teeth, {spacing}, floor {length}, difference {level_difference}")


def spike_room(length: Number) -> Pslg:
    """Return the room [0, length] x [0, 2], length >= 3, with one spike from the ceiling to (3/2, 1)."""
    return ring([(0, 0), (length, 0), (length, 2), (2, 2), (mpq(3, 2), 1), (1, 2), (0, 2)],
                f"room of length {length} with a spike")


def l_shape(length: Number) -> Pslg:
    """Return the hexagon (0,1), (2,1), (2,0), (L,0), (L,2), (0,2), L > 2: the paper's P6 degrades with L."""
    return ring([(0, 1), (2, 1), (2, 0), (length, 0), (length, 2), (0, 2)], f"L of length {length}")


def rectangular_spiral(turns: int) -> Pslg:
    """Return a corridor of width 1 between walls of thickness 1, wound `turns` times (n = 8 turns + 2)."""
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    segments = 4 * turns
    at = (0, 0)
    left: list[Pair] = []
    right: list[Pair] = []
    normals = [(-dy, dx) for dx, dy in directions]
    for i in range(segments + 1):
        into = normals[max(i - 1, 0) % 4]
        out = normals[min(i, segments - 1) % 4]
        # At an end the two normals agree and only one of them counts.
        nx, ny = into if into == out else (into[0] + out[0], into[1] + out[1])
        left.append((at[0] + mpq(nx, 2), at[1] + mpq(ny, 2)))
        right.append((at[0] - mpq(nx, 2), at[1] - mpq(ny, 2)))
        dx, dy = directions[i % 4]
        length = 2 * (i // 2 + 1)
        at = (at[0] + dx * length, at[1] + dy * length)
    return ring(right + left[::-1], f"rectangular spiral of {turns} turns")


def curved_spiral(turns: int, per_turn: int = 16) -> Pslg:
    """Return a corridor of width about 1 wound `turns` times, rational points on circles of growing radius.

    Position i of the 1 + turns * per_turn lies at the radii 2 + 2 i/per_turn and 3 + 2 i/per_turn along the
    directions of `regular_polygon(per_turn)`; n = 2 (1 + turns * per_turn).
    """
    directions = _near_circle(per_turn)
    inner: list[Pair] = []
    outer: list[Pair] = []
    for i in range(turns * per_turn + 1):
        x, y = directions[i % per_turn]
        radius = 2 + Fraction(2 * i, per_turn)
        inner.append((x * radius, y * radius))
        outer.append((x * (radius + 1), y * (radius + 1)))
    return ring(outer + inner[::-1], f"curved spiral of {turns} turns")


def convex_spike(angle: Number = SHARP) -> Pslg:
    """Return a 4 x 4 square with a spike of base 1 and length 1/angle: its tip angle is about `angle`."""
    length = 1 / mpq(angle)
    return ring([(0, 0), (4, 0), (4, mpq(3, 2)), (4 + length, 2), (4, mpq(5, 2)), (4, 4), (0, 4)],
                f"convex spike of angle {angle}")


def reflex_notch(angle: Number = SHARP) -> Pslg:
    """Return a room of height 5 with a notch of base 1 and length 1/angle in its left wall."""
    length = 1 / mpq(angle)
    return ring([(0, 0), (length + 4, 0), (length + 4, 5), (0, 5), (0, 3), (length, mpq(5, 2)), (0, 2)],
                f"reflex notch of angle {angle}")


def sliver(length: Number, rise: Number = SHARP, bends: int = 0) -> Pslg:
    """Return a nearly horizontal strip of height 1 and this length: the ends of each piece differ by `rise`.

    `bends` = 0 gives the parallelogram (0,0), (length, rise), (length, 1 + rise), (0, 1); otherwise both long
    sides have that many vertices, alternately raised by `rise` and not (n = 4 + 2 bends).
    """
    count = bends + 1
    lower = [(mpq(length) * i / count, mpq(rise) * (i % 2)) for i in range(count + 1)]
    upper = [(x, y + 1) for x, y in reversed(lower)]
    return ring([*lower, *upper], f"sliver {length} x 1, rise {rise}, {bends} bends")


def star(n: int, inner: Number = Fraction(1, 8)) -> Pslg:
    """Return a star with n >= 3 spikes as long as the figure: radii 1 and `inner` in turn, 2 n vertices."""
    corners = [(x * r, y * r) for i, (x, y) in enumerate(_near_circle(2 * n))
               for r in (Fraction(1) if i % 2 == 0 else Fraction(inner),)]
    return ring(corners, f"star of {n} spikes")


def staircase(steps: int, tread: Number = 1, riser: Number = 1) -> Pslg:
    """Return a staircase of `steps` >= 1 steps above a floor, highest at the left (n = 2 steps + 2)."""
    a, b = mpq(tread), mpq(riser)
    corners: list[Pair] = [(0, 0), (steps * a, 0)]
    for i in range(steps):
        corners += [((steps - i) * a, (i + 1) * b), ((steps - i - 1) * a, (i + 1) * b)]
    return ring(corners, f"staircase of {steps} steps, {tread} x {riser}")


# --- changes ---


def _moved(pslg: Pslg, move: Callable[[Point], Pair], what: str) -> Pslg:
    def moved(p: Point) -> Point:
        x, y = move(p)
        return Point(mpq(x), mpq(y))

    return Pslg(tuple(map(moved, pslg.vertices)), pslg.edges, tuple(map(moved, pslg.holes)),
                name=f"{pslg.name}, {what}")


def scaled(pslg: Pslg, factor: Number) -> Pslg:
    """Return `pslg` with every coordinate multiplied by `factor` > 0."""
    return _moved(pslg, lambda p: (p.x * mpq(factor), p.y * mpq(factor)), f"scaled by {factor}")


def translated(pslg: Pslg, dx: Number, dy: Number) -> Pslg:
    """Return `pslg` moved by (dx, dy)."""
    return _moved(pslg, lambda p: (p.x + mpq(dx), p.y + mpq(dy)), f"moved by ({dx}, {dy})")


def rotated(pslg: Pslg, t: Number) -> Pslg:
    """Return `pslg` turned about the origin, exactly, by cosine (1-t^2)/(1+t^2) and sine 2t/(1+t^2)."""
    t = mpq(t)
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return _moved(pslg, lambda p: (cosine * p.x - sine * p.y, sine * p.x + cosine * p.y), f"turned by {t}")


def mirrored(pslg: Pslg) -> Pslg:
    """Return `pslg` reflected in the y-axis; the vertices keep their order: a polygon becomes clockwise."""
    return _moved(pslg, lambda p: (-p.x, p.y), "mirrored")


def big_coordinates(pslg: Pslg, seed: int) -> Pslg:
    """Return `pslg` on integers of 30 digits, each vertex moved at random by up to 1e-12 of the extent.

    Such moves keep a PSLG valid when its minimum feature size is more than 1e-11 of the extent, but neither
    collinearity nor equality of levels. Hole points are moved like vertices.
    """
    source = random.Random(seed)
    points = (*pslg.vertices, *pslg.holes)
    left, low = min(p.x for p in points), min(p.y for p in points)
    extent = max(max(p.x for p in points) - left, max(p.y for p in points) - low)
    # The extent becomes 8e29, from 1e29 up: 30 digits throughout.
    factor = 8 * 10**29 / mpq(extent)

    def big(value: mpq) -> int:
        return 10**29 + int(value * factor) + source.randint(0, 8 * 10**17)

    return _moved(pslg, lambda p: (big(p.x - left), big(p.y - low)), f"30 digits, seed {seed}")


def _relabelled(pslg: Pslg, order: Sequence[int], edges: Iterable[Edge], what: str) -> Pslg:
    """Return `pslg` with old vertex order[i] as vertex i."""
    new = {old: i for i, old in enumerate(order)}
    return Pslg(tuple(pslg.vertices[old] for old in order), tuple((new[u], new[v]) for u, v in edges),
                pslg.holes, name=f"{pslg.name}, {what}")


def reversed_orientation(pslg: Pslg) -> Pslg:
    """Return `pslg` with its vertices, its edges and the ends of each edge in reverse order."""
    edges = [(v, u) for u, v in reversed(pslg.edges)]
    return _relabelled(pslg, range(len(pslg.vertices))[::-1], edges, "reversed")


def with_start(pslg: Pslg, k: int) -> Pslg:
    """Return `pslg` with vertex k first; the vertices before it come last."""
    count = len(pslg.vertices)
    shift = k % len(pslg.edges) if pslg.edges else 0
    return _relabelled(pslg, [(i + k) % count for i in range(count)], pslg.edges[shift:] + pslg.edges[:shift],
                       f"from vertex {k}")


def with_collinear_vertices(pslg: Pslg, k: int) -> Pslg:
    """Return `pslg` with every edge cut into k + 1 equal parts by k vertices (180 degrees each).

    The vertices of a polygon stay in cyclic order; those of any other PSLG are appended, edge by edge.
    """
    def cut(u: Point, v: Point) -> list[Point]:
        parts = [mpq(j, k + 1) for j in range(1, k + 1)]
        return [Point(u.x + (v.x - u.x) * part, u.y + (v.y - u.y) * part) for part in parts]

    name = f"{pslg.name}, {k} vertices on each edge"
    count = len(pslg.vertices)
    if pslg.edges == tuple((i, (i + 1) % count) for i in range(count)):
        ends = [(pslg.vertices[u], pslg.vertices[v]) for u, v in pslg.edges]
        return ring([p for u, v in ends for p in (u, *cut(u, v))], name)
    vertices = list(pslg.vertices)
    edges: list[Edge] = []
    for u, v in pslg.edges:
        chain = [u, *range(len(vertices), len(vertices) + k), v]
        vertices += cut(pslg.vertices[u], pslg.vertices[v])
        edges += pairwise(chain)
    return Pslg(tuple(vertices), tuple(edges), pslg.holes, name=name)


# --- random polygons ---


def random_simple_polygon(n: int, seed: int, kind: str = "growth") -> Pslg:
    """Return a random simple polygon with exactly n >= 3 vertices on integer coordinates.

    The kinds are those of `KINDS`:
      grid       the boundary of a thickened random tree: axis-parallel, many straight angles and equal levels
      growth     the same with every vertex moved at random by less than 1/4: winding, in general position
      monotone   two x-monotone chains
      partition  recursive halving by random lines (Auer and Held 1996), spiky
      star       a star-shaped polygon with random radii
      two-opt    a random tour of random points made simple by uncrossing; meant for n <= 200
    All but two-opt take about 0.1 seconds at n = 10,000.
    """
    if n < 3:
        raise ValueError(f"a polygon has at least 3 vertices, not {n}")
    source = random.Random(f"{kind} {n} {seed}")
    corners = _triangle(source) if n == 3 else KINDS[kind](n, source)
    return ring(corners if _area(corners) > 0 else corners[::-1], f"random {kind} {n}, seed {seed}")


def _turn(a: Lattice, b: Lattice, c: Lattice) -> int:
    """Return twice the signed area of the triangle a, b, c."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _area(corners: Sequence[Lattice]) -> int:
    """Return twice the signed area of a polygon."""
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, [*corners[1:], corners[0]], strict=True))


def _lattice_points(n: int, source: random.Random) -> list[Lattice]:
    """Return n distinct points with coordinates below 100 n."""
    size = 100 * n
    chosen: dict[Lattice, None] = {}
    while len(chosen) < n:
        chosen[source.randrange(size), source.randrange(size)] = None
    return list(chosen)


def _triangle(source: random.Random) -> list[Lattice]:
    while True:
        corners = _lattice_points(3, source)
        if _turn(*corners):
            return corners


def _tree_cells(nodes: int, source: random.Random) -> set[Lattice]:
    """Return the unit squares of a random tree: a node is a square (2i, 2j), an edge one between two."""
    cells: set[Lattice] = {(0, 0)}
    frontier = [((0, 0), step) for step in ((2, 0), (-2, 0), (0, 2), (0, -2))]
    while len(cells) < 2 * nodes - 1:
        # A random open end, from among the last ones half of the time: winding and bushy parts in one tree.
        window = len(frontier) if source.random() < 0.5 else min(len(frontier), 6)
        at = len(frontier) - 1 - source.randrange(window)
        (x, y), (dx, dy) = frontier[at]
        frontier[at] = frontier[-1]
        frontier.pop()
        node = (x + dx, y + dy)
        if node in cells:
            continue
        cells |= {node, (x + dx // 2, y + dy // 2)}
        steps = [(2, 0), (-2, 0), (0, 2), (0, -2)]
        source.shuffle(steps)
        frontier += [(node, step) for step in steps]
    return cells


def _boundary(cells: set[Lattice]) -> list[Lattice]:
    """Return all lattice points on the boundary of a simply connected union of squares, counter-clockwise."""
    follow: dict[Lattice, Lattice] = {}
    for x, y in cells:
        if (x, y - 1) not in cells:
            follow[x, y] = (x + 1, y)
        if (x + 1, y) not in cells:
            follow[x + 1, y] = (x + 1, y + 1)
        if (x, y + 1) not in cells:
            follow[x + 1, y + 1] = (x, y + 1)
        if (x - 1, y) not in cells:
            follow[x, y + 1] = (x, y)
    start = min(follow)
    walk = [start]
    while (at := follow[walk[-1]]) != start:
        walk.append(at)
    return walk


def _grid(n: int, source: random.Random) -> list[Lattice]:
    for nodes in range(-(-n // 3), n // 4 - 1, -1):
        walk = _boundary(_tree_cells(nodes, source))
        straight = [i for i, p in enumerate(walk) if _turn(walk[i - 1], p, walk[(i + 1) % len(walk)]) == 0]
        surplus = len(walk) - n
        if 0 <= surplus <= len(straight):
            dropped = set(source.sample(straight, surplus))
            return [p for i, p in enumerate(walk) if i not in dropped]
    raise ValueError(f"no tree has a boundary of {n} vertices")


def _growth(n: int, source: random.Random) -> list[Lattice]:
    # Unmoved, a vertex is at least 1 from an edge that does not contain it; both move by less than 1/3.
    return [(1000 * x + source.randint(-230, 230), 1000 * y + source.randint(-230, 230))
            for x, y in _grid(n, source)]


def _monotone(n: int, source: random.Random) -> list[Lattice]:
    sides = [source.random() < 0.5 for _ in range(n - 2)]
    xs = sorted(source.sample(range(1, 100 * n), n - 2))
    points = [(x, source.randint(1, 100 * n) * (1 if up else -1)) for x, up in zip(xs, sides, strict=True)]
    lower = [p for p in points if p[1] < 0]
    upper = [p for p in points if p[1] > 0]
    return [(0, 0), *lower, (100 * n, 0), *reversed(upper)]


def _star_shaped(n: int, source: random.Random) -> list[Lattice]:
    """Return points around the origin, one a direction, four of them on the axes: no gap is too wide."""
    size = 100 * n
    rays = {(1, 0): (source.randint(1, size), 0), (0, 1): (0, source.randint(1, size)),
            (-1, 0): (-source.randint(1, size), 0), (0, -1): (0, -source.randint(1, size))}
    while len(rays) < n:
        x, y = source.randint(-size, size), source.randint(-size, size)
        if divisor := math.gcd(x, y):
            rays.setdefault((x // divisor, y // divisor), (x, y))

    def key(ray: Lattice) -> tuple[int, Fraction]:
        x, y = ray
        if x > 0 and y >= 0:
            return 0, Fraction(y, x)
        if y > 0:
            return 1, Fraction(-x, y)
        return (2, Fraction(y, x)) if x < 0 else (3, Fraction(x, -y))

    return [rays[ray] for ray in sorted(rays, key=key)]


def _partition(n: int, source: random.Random) -> list[Lattice]:
    while True:
        a, b, *others = _lattice_points(n, source)
        above = [p for p in others if _turn(a, b, p) > 0]
        below = [p for p in others if _turn(a, b, p) < 0]
        forth, back = _chain(a, b, below, source), _chain(b, a, above, source)
        # Exactly collinear points are rare at this density: draw again.
        if below and above and len(below) + len(above) == n - 2 and forth and back:
            return forth + back


def _chain(a: Lattice, b: Lattice, points: list[Lattice], source: random.Random) -> list[Lattice]:
    """Return a simple chain from a through all points, b left out, in their hull; [] on a coincidence."""
    chain: list[Lattice] = []
    stack = [(a, b, points)]
    while stack:
        a, b, points = stack.pop()
        if not points:
            chain.append(a)
            continue
        c = source.choice(points)
        part = source.randint(1, 999)
        # q = a + (b - a) part/1000: the line q c separates a from b. All coordinates below are 1000-fold.
        q = (1000 * a[0] + (b[0] - a[0]) * part, 1000 * a[1] + (b[1] - a[1]) * part)
        c1000 = (1000 * c[0], 1000 * c[1])
        side_of_a = _turn(q, c1000, (1000 * a[0], 1000 * a[1])) > 0
        near: list[Lattice] = []
        far: list[Lattice] = []
        for p in points:
            if p != c:
                turn = _turn(q, c1000, (1000 * p[0], 1000 * p[1]))
                if turn == 0:
                    return []
                (near if (turn > 0) == side_of_a else far).append(p)
        stack += [(c, b, far), (a, c, near)]
    return chain


def _two_opt(n: int, source: random.Random) -> list[Lattice]:
    tour = _lattice_points(n, source)
    crossed = True
    while crossed:
        crossed = False
        for i in range(n - 1):
            for j in range(i + 2, n - (i == 0)):
                a, b, c, d = tour[i], tour[i + 1], tour[j], tour[(j + 1) % n]
                if (_turn(a, b, c) * _turn(a, b, d) <= 0 and _turn(c, d, a) * _turn(c, d, b) <= 0
                        and _shorter(a, b, c, d)):
                    tour[i + 1 : j + 1] = tour[i + 1 : j + 1][::-1]
                    crossed = True
    return tour


def _shorter(a: Lattice, b: Lattice, c: Lattice, d: Lattice) -> bool:
    """Return whether ac + bd < ab + cd, which holds for every crossing and lets the loop end."""
    return math.dist(a, c) + math.dist(b, d) < math.dist(a, b) + math.dist(c, d)


KINDS: dict[str, Callable[[int, random.Random], list[Lattice]]] = {
    "grid": _grid, "growth": _growth, "monotone": _monotone, "partition": _partition, "star": _star_shaped,
    "two-opt": _two_opt}


# --- general PSLGs ---


class _Builder:
    """Vertices, edges and holes put together piece by piece."""

    def __init__(self) -> None:
        self.vertices: list[Point] = []
        self.edges: list[Edge] = []
        self.holes: list[Point] = []

    def add(self, points: Iterable[Pair], edges: Iterable[Edge], shift: Pair = (0, 0),
            unit: Number = 1) -> None:
        """Add a piece: its points times `unit`, then moved by `shift`; its edges count from its first."""
        first = len(self.vertices)
        self.vertices += [_place(p, shift, unit) for p in points]
        self.edges += [(first + u, first + v) for u, v in edges]

    def pslg(self, name: str) -> Pslg:
        return Pslg(tuple(self.vertices), tuple(self.edges), tuple(self.holes), name=name)


def _place(p: Pair, shift: Pair, unit: Number) -> Point:
    return Point(mpq(shift[0]) + mpq(p[0]) * mpq(unit), mpq(shift[1]) + mpq(p[1]) * mpq(unit))


def _cycle(n: int) -> list[Edge]:
    return [(i, (i + 1) % n) for i in range(n)]


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
    builder = _Builder()
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
    builder = _Builder()
    side = 10 * cells
    builder.add([(0, 0), (side, 0), (side, side), (0, side)], _cycle(4))
    for column in range(cells):
        for row in range(cells):
            source.choice(_FEATURES)(builder, (10 * column + 5, 10 * row + 5), source)
    if source.random() < 0.5:
        builder.add([(side + 2, 0), (side + 9, 1), (side + 5, 8)], _cycle(3))
    if source.random() < 0.5:
        _tree(builder, (-6, 5), source)
    return builder.pslg(f"random pslg of {cells} x {cells} cells, seed {seed}")


def _small_ring(size: int, source: random.Random) -> list[Lattice]:
    return _star_shaped(source.randint(4, size), source)


def _ring_of(builder: _Builder, at: Pair, radius: Number, source: random.Random) -> None:
    """Add a star-shaped ring with every vertex within max-norm `radius` of `at`."""
    corners = _small_ring(9, source)
    largest = max(max(abs(x), abs(y)) for x, y in corners)
    builder.add(corners, _cycle(len(corners)), at, mpq(radius) / largest)


def _nothing(builder: _Builder, at: Lattice, source: random.Random) -> None:
    """Leave a cell empty."""


def _hole(builder: _Builder, at: Lattice, source: random.Random) -> None:
    _ring_of(builder, at, 4, source)
    builder.holes.append(_place((0, 0), at, 1))


def _island(builder: _Builder, at: Lattice, source: random.Random) -> None:
    _ring_of(builder, at, 4, source)


def _nested(builder: _Builder, at: Lattice, source: random.Random) -> None:
    # Squares on their corners, turned: each fits into the disc in the one before.
    for half in (40, 25, 15):
        turn = source.randint(-9, 9)
        corners = [(half, turn), (-turn, half), (-half, -turn), (turn, -half)]
        builder.add(corners, _cycle(4), at, Fraction(1, 10))
    if source.random() < 0.5:
        outer, inner = builder.vertices[-12], builder.vertices[-8]
        builder.holes.append(Point((outer.x + inner.x) / 2, (outer.y + inner.y) / 2))


def _tree(builder: _Builder, at: Lattice, source: random.Random) -> None:
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


def _points(builder: _Builder, at: Lattice, source: random.Random) -> None:
    places = source.sample([(x, y) for x in range(-3, 4) for y in range(-3, 4)], source.randint(1, 4))
    builder.add(places, [], at)


def _small_map(builder: _Builder, at: Lattice, source: random.Random) -> None:
    inner = grid_map(2, 2, source.randrange(10**6))
    builder.add([(p.x - 1, p.y - 1) for p in inner.vertices], inner.edges, at, 2)


def _single_edge(builder: _Builder, at: Lattice, source: random.Random) -> None:
    ends = [(sign * source.randint(1, 4), source.randint(-4, 4)) for sign in (-1, 1)]
    builder.add(ends, [(0, 1)], at)


_FEATURES = (_nothing, _hole, _island, _nested, _tree, _points, _small_map, _single_edge)


# --- collections ---


def _small() -> dict[str, Pslg]:
    base = {
        "triangle": ring([(0, 0), (4, 0), (1, 3)]),
        "triangle with vertices on its sides": with_collinear_vertices(ring([(0, 0), (4, 0), (1, 3)]), 2),
        "square": regular_polygon(4),
        "unit square": ring([(0, 0), (1, 0), (1, 1), (0, 1)]),
        "pentagon": regular_polygon(5),
        "hexagon": regular_polygon(6),
        "13-gon": regular_polygon(13),
        "40-gon": regular_polygon(40),
        "midway 3": rectangle_with_two_midway_vertices(3),
        "midway 100": rectangle_with_two_midway_vertices(100),
        "comb 1": comb(1),
        "comb 5": comb(5),
        "comb 12 long floor": comb(12, 500),
        "comb 8 uneven": comb(8, 60, "uneven"),
        "comb 8 doubling": comb(8, 600, "doubling"),
        "comb 10 nearly level": comb(10, 40, "even", SHARP),
        "comb 9 uneven nearly level": comb(9, 70, "uneven", SHARP),
        "spike room": spike_room(1000),
        "l-shape 44": l_shape(44),
        "rectangular spiral": rectangular_spiral(3),
        "curved spiral": curved_spiral(2, 12),
        "convex spike 1e-6": convex_spike(),
        "convex spike 1e-2": convex_spike(Fraction(1, 100)),
        "reflex notch 1e-6": reflex_notch(),
        "reflex notch 1e-2": reflex_notch(Fraction(1, 100)),
        "sliver": sliver(1000),
        "sliver with bends": sliver(10**6, SHARP, 9),
        "star 5": star(5),
        "star 12": star(12),
        "staircase": staircase(9),
        "flat staircase": staircase(8, 100, Fraction(1, 7)),
    }
    for kind in KINDS:
        for n in (4, 9, 24, 50):
            base[f"{kind} {n}"] = random_simple_polygon(n, 1, kind)
    ell, tooth = l_shape(20), comb(4, 30, "uneven")
    changed = {
        "30 digits": big_coordinates(random_simple_polygon(30, 2, "growth"), 1),
        "30 digits comb": big_coordinates(tooth, 2),
        "tiny": scaled(tooth, Fraction(1, 10**30)),
        "huge": scaled(ell, 10**30),
        "far away": translated(ell, 10**12, Fraction(-(10**12), 7)),
        "turned l-shape": rotated(ell, Fraction(1, 3)),
        "turned comb": rotated(tooth, Fraction(17, 1000)),
        "slightly turned comb": rotated(tooth, SHARP),
        "mirrored": mirrored(tooth),
        "reversed": reversed_orientation(tooth),
        "started elsewhere": with_start(tooth, 5),
        "collinear vertices": with_collinear_vertices(tooth, 3),
        "collinear vertices on a turned l-shape": with_collinear_vertices(rotated(ell, Fraction(2, 7)), 4),
    }
    return base | changed


def _named(inputs: dict[str, Pslg]) -> dict[str, Pslg]:
    """Give every input the name it is filed under."""
    return {name: Pslg(p.vertices, p.edges, p.holes, name=name) for name, p in inputs.items()}


ALL_SMALL: dict[str, Pslg] = _named(_small())
"""Simple polygons of at most 60 vertices, of every family."""

SMALL_PSLGS: dict[str, Pslg] = _named(
    {f"random pslg {seed}": random_pslg(seed, 2) for seed in range(8)}
    | {f"map {seed}": grid_map(4, 3, seed) for seed in range(3)}
    | {"turned pslg": rotated(random_pslg(20, 2), Fraction(1, 9)),
       "square and two points": Pslg(
           ring([(0, 0), (4, 0), (4, 4), (0, 4), (2, 2), (mpq(17, 8), 2)]).vertices, tuple(_cycle(4))),
       "two squares": Pslg(ring([(0, 0), (2, 0), (2, 2), (0, 2), (5, 0), (6, 0), (6, 1), (5, 1)]).vertices,
                           (*_cycle(4), (4, 5), (5, 6), (6, 7), (7, 4)))})
"""General PSLGs of at most about 60 vertices: holes, nested rings, trees, isolated points, maps."""


def issue_list() -> dict[str, Pslg]:
    """Return every family in representative sizes up to 200 vertices, simple polygons all."""
    found: dict[str, Pslg] = {}
    for n in (3, 4, 5, 6, 7, 8, 12, 17, 32, 64, 100, 200):
        found[f"regular {n}"] = regular_polygon(n)
    for r in (2, 3, 4, 10, 100, 10**4, 10**6):
        found[f"midway {r}"] = rectangle_with_two_midway_vertices(r)
    for teeth in (1, 2, 3, 10, 30, 98):
        for spacing in ("even", "uneven"):
            for difference in (0, SHARP):
                found[f"comb {teeth} {spacing} difference {difference}"] = comb(
                    teeth, 6 * (teeth + 1), spacing, difference)
        found[f"comb {teeth} long floor"] = comb(teeth, 10**4)
    found["comb 16 doubling"] = comb(16, 10**6, "doubling")
    for length in (3, 10, 10**3, 10**6):
        found[f"spike room {length}"] = spike_room(length)
        found[f"l-shape {length}"] = l_shape(length)
    for length in (44, 96, 192):
        found[f"l-shape {length}"] = l_shape(length)
    for turns in (1, 5, 24):
        found[f"rectangular spiral {turns}"] = rectangular_spiral(turns)
    for turns, per_turn in ((1, 12), (3, 16), (4, 24)):
        found[f"curved spiral {turns}"] = curved_spiral(turns, per_turn)
    for angle in (Fraction(1, 10), Fraction(1, 1000), SHARP):
        found[f"convex spike {angle}"] = convex_spike(angle)
        found[f"reflex notch {angle}"] = reflex_notch(angle)
    for bends in (0, 1, 10, 90):
        found[f"sliver {bends} bends"] = sliver(10**5, SHARP, bends)
    for spikes in (3, 5, 20, 100):
        found[f"star {spikes}"] = star(spikes)
    for steps in (1, 10, 99):
        found[f"staircase {steps}"] = staircase(steps)
        found[f"nearly flat staircase {steps}"] = staircase(steps, 10, SHARP)
    for kind in KINDS:
        for n, seed in ((10, 1), (40, 2), (100, 3), (200, 4)):
            found[f"{kind} {n}"] = random_simple_polygon(n, seed, kind)
    for name in ("comb 10 uneven difference 0", "growth 40", "partition 100", "l-shape 96",
                 "reflex notch 1/1000"):
        base = found[name]
        found |= {f"{name}, 30 digits": big_coordinates(base, 7),
                  f"{name}, scale 1e-30": scaled(base, Fraction(1, 10**30)),
                  f"{name}, turned": rotated(base, Fraction(2, 9)),
                  f"{name}, nearly unturned": rotated(base, SHARP),
                  f"{name}, far away": translated(base, 10**15, Fraction(-(10**15), 3)),
                  f"{name}, mirrored": mirrored(base),
                  f"{name}, reversed": reversed_orientation(base),
                  f"{name}, started elsewhere": with_start(base, len(base.vertices) // 2),
                  f"{name}, collinear vertices": with_collinear_vertices(base, 1)}
    return _named(found)


# --- domains and kinds: maps, rings, trees, walls ---


def nested_rings(depth: int, seed: int = 0, marked: bool = False) -> Pslg:
    """Return `depth` nested squares, turned at random, about 1 apart; when `marked` every second gap is a hole."""
    source = random.Random(f"nested {depth} {seed}")
    builder = _Builder()
    for i in range(depth):
        # A square of half diagonal h, slightly turned, lies between the circles of radius 0.7 h and 1.03 h.
        half = mpq(100 * 160**i, 100**i)
        turn = half * Fraction(source.randint(-200, 200), 1000)
        builder.add([(half, turn), (-turn, half), (-half, -turn), (turn, -half)], _cycle(4))
        if marked and i % 2:
            builder.holes.append(_place((half, turn), (0, 0), mpq(96, 100)))
    return builder.pslg(f"{depth} nested rings, seed {seed}")


def polygon_with_holes(columns: int, rows: int, seed: int, marked: bool = True) -> Pslg:
    """Return a rectangle with columns x rows star-shaped rings of 4 to 9 vertices in it, holes when `marked`."""
    source = random.Random(f"holes {columns} {rows} {seed}")
    builder = _Builder()
    builder.add([(0, 0), (10 * columns, 0), (10 * columns, 10 * rows), (0, 10 * rows)], _cycle(4))
    for column in range(columns):
        for row in range(rows):
            _ring_of(builder, (10 * column + 5, 10 * row + 5), Fraction(source.randint(5, 45), 10), source)
            if marked:
                builder.holes.append(_place((0, 0), (10 * column + 5, 10 * row + 5), 1))
    return builder.pslg(f"{columns} x {rows} holes, seed {seed}")


def wheel(spokes: int, rim: bool = True) -> Pslg:
    """Return a vertex of degree `spokes`: joined to a rim, or with its spokes dangling in a square."""
    builder = _Builder()
    circle = _near_circle(spokes)
    builder.add([(0, 0), *circle], [(0, i + 1) for i in range(spokes)], unit=10)
    if rim:
        builder.edges += [(u + 1, v + 1) for u, v in _cycle(spokes)]
    else:
        builder.add([(-15, -16), (17, -15), (15, 16), (-17, 15)], _cycle(4))
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
    builder = _Builder()
    builder.add(at, tree)
    builder.add([(-2, -2), (columns + 1, -2), (columns + 1, rows + 1), (-2, rows + 1)], _cycle(4))
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
    builder = _Builder()
    builder.add(at, kept)
    builder.add([(0, 0), (side, 0), (side, side), (0, side)], _cycle(4))
    return builder.pslg(f"{points} points, {edges} segments, seed {seed}")


def _is_between(p: Lattice, a: Lattice, b: Lattice) -> bool:
    return _turn(a, b, p) == 0 and min(a, b) <= p <= max(a, b)


def _clash(at: Sequence[Lattice], e: Edge, f: Edge) -> bool:
    """Return whether two edges are the same or cross; that no vertex lies on an edge is tested elsewhere."""
    if set(e) & set(f):
        return set(e) == set(f)
    (a, b), (c, d) = ((at[u], at[v]) for u, v in (e, f))
    return _turn(a, b, c) * _turn(a, b, d) < 0 and _turn(c, d, a) * _turn(c, d, b) < 0


def spike_with_ledges(n: int, seed: int) -> Pslg:
    """Return a long sharp spike over a floor with ledges: what step 4 of the repaired construction fears most.

    The upper side is one edge of length 85 to 400 with a slope near 1e-3; the floor has n >= 1 vertices, some of them
    in pairs 1 apart with a drop behind.
    """
    source = random.Random(f"ledges {n} {seed}")
    length = source.randint(85, 400)
    slope = Fraction(source.randint(5, 60), 10**4)
    floor: list[Pair] = [(0, 0)]
    x = Fraction(0)
    drop = Fraction(0)
    for _ in range(n):
        x += Fraction(source.randint(100, 100 * max(2, length // n)), 100)
        if x >= length - 2:
            break
        drop += Fraction(source.randint(0, 300), 10**4)
        floor.append((x, -drop))
        if source.random() < 0.6:
            x += Fraction(source.randint(100, 130), 100)
            floor.append((x, -drop - Fraction(source.randint(0, 20), 10**4)))
            drop += Fraction(source.randint(100, 400), 100)
            x += Fraction(source.randint(0, 100), 1000)
            floor.append((x + Fraction(1, 100), -drop))
    end = max(x + 2, Fraction(length))
    return ring([*floor, (end, -drop - 1), (end, end * slope + 2)], f"spike with {n} ledges, seed {seed}")


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
    builder = _Builder()
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
            builder.add(corners, _cycle(len(corners)))
        builder.add([pslg.vertices[v] for v in face.isolated], [])
        builder.holes += [pslg.vertices[origin[walk[0]]] for walk in face.inner]
    return builder.pslg(f"{pslg.name}, walls of {thickness}")


def slits(count: int, seed: int, width: Number = Fraction(1, 10**6)) -> Pslg:
    """Return a room with `count` thin wedges cut into it from below and from above in turn, tips in random places.

    mfs is about `width`, ifs about 1 or less; with tips near a common level.
    """
    source = random.Random(f"slits {count} {seed}")
    length, half = 3 * count + 3, mpq(width) / 2
    bottom: list[Pair] = [(0, 0)]
    top: list[Pair] = [(length, 6)]
    tops: list[Pair] = []
    for i in range(count):
        x = 3 * i + 3 + Fraction(source.randint(-900, 900), 1000)
        lean = Fraction(source.randint(-900, 900), 1000)
        if i % 2:
            tip = Fraction(source.choice((1000, 1500, 1501, 4000)), 1000)
            tops += [(x - half, 6), (x + lean, tip), (x + half, 6)]
        else:
            tip = Fraction(source.choice((5000, 4500, 4499, 2000)), 1000)
            bottom += [(x - half, 0), (x + lean, tip), (x + half, 0)]
    return ring([*bottom, (length, 0), *top, *tops[::-1], (0, 6)], f"{count} slits of {width}, seed {seed}")


def walled_spiral(turns: int, thickness: Number, per_turn: int = 16) -> Pslg:
    """Return a corridor of width about 1 wound around itself with a wall of this thickness between the turns."""
    directions = _near_circle(per_turn)
    count = turns * per_turn
    outer: list[Pair] = []
    inner: list[Pair] = []
    for i in range(count + 1):
        x, y = directions[i % per_turn]
        radius = 2 + Fraction(i, per_turn)
        inner.append((x * radius, y * radius))
        outer.append((x * (radius + 1 - mpq(thickness)), y * (radius + 1 - mpq(thickness))))
    return ring([*outer, *inner[::-1]], f"walled spiral of {turns} turns")


def leaning_strip(run: Number, offset: Number, start: Number = Fraction(501, 1000), pieces: int = 1) -> Pslg:
    """Return a long strip of height just above 1 that rises by one level of the repaired construction per `run`.

    Below there are vertices every `run`, from `start` levels up, above as well but `offset` to the left (180 degrees
    all): both sides are snapped towards each other when the offset is a little above 0.31 run.
    """
    slope = LEVEL / mpq(run)
    low = mpq(start) * LEVEL
    inner = [k * mpq(run) for k in range(pieces + 1)]
    ends = [-3 * mpq(run)], [(pieces + 3) * mpq(run)]
    below, above = [*ends[0], *inner, *ends[1]], [*ends[0], *(x - mpq(offset) for x in inner), *ends[1]]
    height = 1 + slope**2
    return ring([*((x, low + slope * x) for x in below), *((x, low + slope * x + height) for x in above[::-1])],
                f"leaning strip, {run} a level, offset {offset}")
