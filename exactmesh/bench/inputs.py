"""The inputs of the benchmark: families with about any number of vertices, exact and the same in every run."""

import random
from collections.abc import Callable
from fractions import Fraction
from math import isqrt

from gmpy2 import mpq

from exactmesh.data import EXAMPLES
from exactmesh.families.build import ring
from exactmesh.families.domains import grid_map
from exactmesh.families.random_polygons import random_simple_polygon
from exactmesh.families.shapes import comb, curved_spiral, regular_polygon, star
from exactmesh.geometry.point import Point
from exactmesh.io.read import read_pslg
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.numbers.rational import sqrt_below
from exactmesh.planar.pslg import Edge, Pslg

LEAST = 60
_COAST = "ireland"


def roof(n: int) -> Pslg:
    """Return a polygon of n vertices, all but two of them below one long edge that is not quite horizontal."""
    floor = [(i, mpq(i * i % 7, 8)) for i in range(n - 2)]
    return ring([*floor, (n - 3, 3 + mpq(1, 10**6)), (0, 3)], f"roof over {n - 2} vertices")


def coast(n: int) -> Pslg:
    """Return a real coastline whose edges are bent at as many vertices as it takes to have about n; at least its own.

    On an edge with k new vertices these are moved aside by at most mfs/(4 (k + 1)). Any other edge is farther from
    there: where it shares no vertex, by mfs; where it does, by the distance to that vertex over the length of the edge
    times mfs, which is mfs/(k + 1) at least.
    """
    outline = read_pslg(str(EXAMPLES.path(_COAST))).pslg
    nearest = minimum_feature_size(outline)
    if nearest is None:
        raise AssertionError("an outline has a feature size")
    source = random.Random(n)
    vertices = list(outline.vertices)
    edges: list[Edge] = []
    more = max(0, n - len(vertices))
    for e, (u, v) in enumerate(outline.edges):
        count = more * (e + 1) // len(outline.edges) - more * e // len(outline.edges)
        p, q = outline.vertices[u], outline.vertices[v]
        x, y = q.x - p.x, q.y - p.y
        aside = sqrt_below(nearest.squared / (x * x + y * y), 8) / (4 * (count + 1))
        last = u
        for i in range(1, count + 1):
            t, s = mpq(i, count + 1), aside * mpq(source.randint(-8, 8), 8)
            vertices.append(Point(p.x + t * x - s * y, p.y + t * y + s * x))
            edges.append((last, len(vertices) - 1))
            last = len(vertices) - 1
        edges.append((last, v))
    return Pslg(tuple(vertices), tuple(edges), name=f"{_COAST} with {len(vertices)} vertices")


def country_map(n: int) -> Pslg:
    """Return a map of about n faces and vertices."""
    side = isqrt(n) - 1
    return grid_map(side, side, 1, Fraction(1))


FAMILIES: dict[str, Callable[[int], Pslg]] = {
    "random": lambda n: random_simple_polygon(n, 1, "partition"),
    "growth": lambda n: random_simple_polygon(n, 1, "growth"),
    "circle": regular_polygon,
    "comb": lambda n: comb((n - 3) // 2),
    "levels": lambda n: comb((n - 3) // 2, level_difference=mpq(1, 10**6)),
    "star": lambda n: star(n // 2),
    "spiral": lambda n: curved_spiral((n // 2 - 1) // 24, 24),
    "coast": coast,
    "roof": roof,
    "map": country_map,
}
WHAT = {
    "random": "random simple polygon by recursive halving", "growth": "winding random polygon",
    "circle": "regular polygon on rational points of a circle", "comb": "comb, all tips on one level",
    "levels": "comb, tips on five nearly equal levels", "star": "star, spikes as long as the figure",
    "spiral": "spiral of 24 vertices a turn", "coast": f"the coast of {_COAST}, edges bent to have the size",
    "roof": "one long near-horizontal edge above all vertices", "map": "map of as many faces as vertices",
}
