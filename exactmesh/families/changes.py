"""Changes that keep a PSLG valid: similarities, another order, vertices on edges, coordinates of many digits."""

import random
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.families.build import Number, Pair, ring
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Edge, Pslg


def moved_by(pslg: Pslg, move: Callable[[Point], Pair], what: str) -> Pslg:
    """Return a PSLG with all vertices and hole points moved; `what` is added to its name."""
    def moved(p: Point) -> Point:
        x, y = move(p)
        return Point(mpq(x), mpq(y))

    return Pslg(tuple(map(moved, pslg.vertices)), pslg.edges, tuple(map(moved, pslg.holes)),
                name=f"{pslg.name}, {what}")


def scaled(pslg: Pslg, factor: Number) -> Pslg:
    """Return `pslg` with every coordinate multiplied by `factor` > 0."""
    return moved_by(pslg, lambda p: (p.x * mpq(factor), p.y * mpq(factor)), f"scaled by {factor}")


def translated(pslg: Pslg, dx: Number, dy: Number) -> Pslg:
    """Return `pslg` moved by (dx, dy)."""
    return moved_by(pslg, lambda p: (p.x + mpq(dx), p.y + mpq(dy)), f"moved by ({dx}, {dy})")


def rotated(pslg: Pslg, t: Number) -> Pslg:
    """Return `pslg` turned about the origin, exactly, by cosine (1-t^2)/(1+t^2) and sine 2t/(1+t^2)."""
    t = mpq(t)
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return moved_by(pslg, lambda p: (cosine * p.x - sine * p.y, sine * p.x + cosine * p.y), f"turned by {t}")


def mirrored(pslg: Pslg) -> Pslg:
    """Return `pslg` reflected in the y-axis; the vertices keep their order: a polygon becomes clockwise."""
    return moved_by(pslg, lambda p: (-p.x, p.y), "mirrored")


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

    return moved_by(pslg, lambda p: (big(p.x - left), big(p.y - low)), f"30 digits, seed {seed}")


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
