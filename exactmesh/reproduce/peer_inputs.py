"""The inputs on which meshers are compared: ordinary ones, of which a median says something, and hard ones.

Groups of ordinary inputs: random polygons of six kinds, outlines of countries, maps, fractals, mazes, domains with
holes. Hard ones: the r x 1 rectangle with two midway vertices, combs, sharp wedges and spikes, regular polygons.
"""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from gmpy2 import mpq

from exactmesh.data import EXAMPLES
from exactmesh.families.build import Pair, ring
from exactmesh.families.domains import boxed_tree, grid_map, polygon_with_holes, random_pslg
from exactmesh.families.random_polygons import KINDS, random_simple_polygon
from exactmesh.families.shapes import comb, convex_spike, rectangle_with_two_midway_vertices, reflex_notch, star
from exactmesh.geometry.point import Point
from exactmesh.io.read import read_pslg
from exactmesh.planar.pslg import Pslg
from exactmesh.reproduce.families import regular_polygon

# The altitude of an equilateral triangle with sides of length 1, rounded.
_ALTITUDE = Fraction(97, 112)
HARD_GROUPS = ("midway", "combs", "sharp", "regular")


@dataclass(frozen=True, slots=True)
class Input:
    """An input by its group and name, made when it is needed."""

    group: str
    name: str
    make: Callable[[], Pslg]


def inputs(short: bool) -> list[Input]:
    """Return all inputs, the ordinary groups first."""
    return [*ordinary(short), *hard(short)]


def ordinary(short: bool) -> Iterator[Input]:
    """Yield the ordinary inputs."""
    for kind in KINDS:
        for n, seeds in ((30, 2), (100, 1)) if short else ((30, 6), (100, 4), (400, 2), (2000, 1)):
            for seed in range(1, seeds + 1):
                yield Input("random", f"{kind} {n} #{seed}", partial(random_simple_polygon, n, seed, kind))
    for name in ("lesotho", "luxembourg") if short else EXAMPLES.names():
        yield Input("outlines", name.removesuffix(".geojson"), partial(_example, name))
    for size, seeds in ((4, 1), (8, 1)) if short else ((4, 3), (8, 3), (16, 2), (30, 1)):
        for seed in range(1, seeds + 1):
            yield Input("maps", f"map {size} x {size} #{seed}", partial(grid_map, size, size, seed))
            yield Input("mazes", f"maze {size} x {size} #{seed}", partial(maze, size, size, seed))
            yield Input("mazes", f"tree {size} x {size} #{seed}", partial(boxed_tree, size, size, seed))
            yield Input("holes", f"{size} x {size} holes #{seed}", partial(polygon_with_holes, size, size, seed))
    for order in range(1, 4 if short else 6):
        yield Input("fractals", f"snowflake {order}", partial(snowflake, order))
    for order in range(1, 3 if short else 4):
        yield Input("fractals", f"square island {order}", partial(square_island, order))
    for seed in range(1, 4 if short else 11):
        yield Input("graphs", f"graph #{seed}", partial(random_pslg, seed))


def hard(short: bool) -> Iterator[Input]:
    """Yield the hard inputs."""
    for r in (4, 100, 10**6) if short else (4, 10, 100, 10**3, 10**4, 10**5, 10**6):
        yield Input("midway", f"r = {r}", partial(rectangle_with_two_midway_vertices, r))
    for k in (2, 5, 20) if short else (2, 3, 5, 10, 20, 50):
        yield Input("combs", f"{k} teeth", partial(comb, k))
    for denominator in (10, 1000) if short else (10, 1000, 10**6):
        angle = Fraction(1, denominator)
        yield Input("sharp", f"spike 1/{denominator}", partial(convex_spike, angle))
        yield Input("sharp", f"notch 1/{denominator}", partial(reflex_notch, angle))
    for n in (5, 20) if short else (5, 20, 50):
        yield Input("sharp", f"star of {n} spikes", partial(star, n))
    for n in (5, 16, 64) if short else (4, 5, 6, 8, 16, 32, 64, 128):
        yield Input("regular", f"{n}-gon", partial(regular_polygon, n))


def snowflake(order: int) -> Pslg:
    """Return Koch's snowflake of an order, 3 * 4^order vertices, with a rational for the root of 3: on a lattice."""
    # In thirds^order of (1, 1/2 + altitude): the directions are six vectors of the triangular lattice.
    turns = [0, 4, 2]
    for _ in range(order):
        turns = [turn for d in turns for turn in (d, (d + 1) % 6, (d - 1) % 6, d)]
    # Seen from inside the bumps must point outward: the walk is clockwise, and reversed.
    steps = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)]
    u = v = 0
    corners: list[Pair] = []
    for d in turns:
        corners.append((u + Fraction(v, 2), v * _ALTITUDE))
        u, v = u + steps[d][0], v + steps[d][1]
    return ring(corners[::-1], f"snowflake of order {order}")


def square_island(order: int) -> Pslg:
    """Return the quadratic Koch island of an order: each side of a square becomes eight, 4 * 8^order vertices."""
    turns = [0, 1, 2, 3]
    for _ in range(order):
        turns = [(d + turn) % 4 for d in turns for turn in (0, 1, 0, 3, 3, 0, 1, 0)]
    x = y = 0
    corners: list[Pair] = []
    for i, d in enumerate(turns):
        if d != turns[i - 1]:  # else the walk goes straight on
            corners.append((x, y))
        x, y = x + (1, 0, -1, 0)[d], y + (0, 1, 0, -1)[d]
    return ring(corners, f"square island of order {order}")


def maze(columns: int, rows: int, seed: int) -> Pslg:
    """Return the walls of a maze of square cells: between any two of them there is one way."""
    source = random.Random(seed)
    walls = {((x, y), (x + 1, y)) for x in range(columns) for y in range(rows + 1)}
    walls |= {((x, y), (x, y + 1)) for x in range(columns + 1) for y in range(rows)}
    seen = {(0, 0)}
    path = [(0, 0)]
    while path:
        x, y = path[-1]
        ways = [(a, b) for a, b in ((x + 1, y), (x, y + 1), (x - 1, y), (x, y - 1))
                if 0 <= a < columns and 0 <= b < rows and (a, b) not in seen]
        if not ways:
            path.pop()
            continue
        a, b = source.choice(ways)
        walls.discard(((max(x, a), max(y, b)), (max(x, a) + (a == x), max(y, b) + (b == y))))
        seen.add((a, b))
        path.append((a, b))
    corners = sorted({corner for wall in walls for corner in wall})
    index = {corner: i for i, corner in enumerate(corners)}
    edges = sorted((index[a], index[b]) for a, b in walls)
    return Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in corners), tuple(edges), name=f"maze of {columns} x {rows}")


def _example(name: str) -> Pslg:
    return read_pslg(str(EXAMPLES.path(name))).pslg
