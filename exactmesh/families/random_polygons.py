"""Random simple polygons on integer coordinates, of six kinds: the same arguments give the same polygon."""

import math
import random
from collections.abc import Callable
from fractions import Fraction

from gmpy2 import mpq

from exactmesh.families.build import SHARP, Lattice, Number, Pair, doubled_area, ring, turn
from exactmesh.planar.pslg import Pslg


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
    return ring(corners if doubled_area(corners) > 0 else corners[::-1], f"random {kind} {n}, seed {seed}")


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
        if turn(*corners):
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
        straight = [i for i, p in enumerate(walk) if turn(walk[i - 1], p, walk[(i + 1) % len(walk)]) == 0]
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


def star_shaped(n: int, source: random.Random) -> list[Lattice]:
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
        above = [p for p in others if turn(a, b, p) > 0]
        below = [p for p in others if turn(a, b, p) < 0]
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
        side_of_a = turn(q, c1000, (1000 * a[0], 1000 * a[1])) > 0
        near: list[Lattice] = []
        far: list[Lattice] = []
        for p in points:
            if p != c:
                side = turn(q, c1000, (1000 * p[0], 1000 * p[1]))
                if side == 0:
                    return []
                (near if (side > 0) == side_of_a else far).append(p)
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
                if (turn(a, b, c) * turn(a, b, d) <= 0 and turn(c, d, a) * turn(c, d, b) <= 0
                        and _shorter(a, b, c, d)):
                    tour[i + 1 : j + 1] = tour[i + 1 : j + 1][::-1]
                    crossed = True
    return tour


def _shorter(a: Lattice, b: Lattice, c: Lattice, d: Lattice) -> bool:
    """Return whether ac + bd < ab + cd, which holds for every crossing and lets the loop end."""
    return math.dist(a, c) + math.dist(b, d) < math.dist(a, b) + math.dist(c, d)


KINDS: dict[str, Callable[[int, random.Random], list[Lattice]]] = {
    "grid": _grid, "growth": _growth, "monotone": _monotone, "partition": _partition, "star": star_shaped,
    "two-opt": _two_opt}


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


def slits(count: int, seed: int, width: Number = SHARP) -> Pslg:
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
