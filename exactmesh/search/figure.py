"""Figures: planar straight-line graphs with integer coordinates, which is what a search moves, compares and stores.

A simple polygon is a figure too, and the most common one: its points are its corners in order. Any other figure has
its points sorted. Everything is exact; scaling any rational input by its common denominator makes it a figure.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import gcd, lcm
from typing import Any, Self

from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.families.build import cycle, turn
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.validate import validate
from exactmesh.search.corners import Corner, Corners, is_between, is_simple, normalised, segments_meet

# Beyond this many points the sweep of the product decides what is planar; below, all pairs are compared.
_ALL_PAIRS = 64


@dataclass(frozen=True, slots=True)
class Figure:
    """Points, edges between them, and points that mark faces to be left empty."""

    points: Corners
    edges: tuple[Edge, ...]
    holes: Corners = ()

    @classmethod
    def polygon(cls, corners: Sequence[Corner]) -> Self:
        """Return the polygon with these corners in order."""
        return cls(tuple(corners), tuple(cycle(len(corners))))

    @classmethod
    def of(cls, pslg: Pslg) -> Self:
        """Return an input, multiplied by the least number that makes all its coordinates whole."""
        scale = lcm(*(int(c.denominator) for p in (*pslg.vertices, *pslg.holes) for c in p))
        return cls(_scaled(pslg.vertices, scale), pslg.edges, _scaled(pslg.holes, scale))

    @classmethod
    def from_json(cls, value: Any) -> Self:
        """Return the figure of a value made by `to_json`."""
        if isinstance(value, dict):
            return cls(_pairs(value["vertices"]), tuple((int(u), int(v)) for u, v in value["edges"]),
                       _pairs(value["holes"]))
        return cls.polygon(_pairs(value))

    @property
    def is_polygon(self) -> bool:
        """Whether the edges lead from each point to the next, and from the last to the first."""
        return not self.holes and self.edges == tuple(cycle(len(self.points)))

    @property
    def places(self) -> Corners:
        """Points and hole points."""
        return self.points + self.holes

    def at(self, places: Sequence[Corner]) -> "Figure":
        """Return the same graph with other points and hole points, as many as there are."""
        count = len(self.points)
        return Figure(tuple(places[:count]), self.edges, tuple(places[count:]))

    def to_json(self) -> object:
        """Return a list of corners for a polygon, an object with vertices, edges and holes for anything else."""
        if self.is_polygon:
            return [list(corner) for corner in self.points]
        return {"vertices": [list(p) for p in self.points], "edges": [list(e) for e in self.edges],
                "holes": [list(p) for p in self.holes]}

    def pslg(self, name: str = "") -> Pslg:
        """Return the figure as an input of the product."""
        return Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in self.points), self.edges,
                    tuple(Point(mpq(x), mpq(y)) for x, y in self.holes), name)

    def text(self) -> str:
        """Return the corners of a polygon, or how many vertices, edges and hole points there are, for reading."""
        if self.is_polygon:
            return " ".join(f"{x},{y}" for x, y in self.points)
        return f"{len(self.points)} vertices, {len(self.edges)} edges, {len(self.holes)} hole points"


def is_planar(figure: Figure) -> bool:
    """Return whether points are distinct, edges meet at common ends only, and no hole point lies on either."""
    if len(figure.points) > _ALL_PAIRS:
        try:
            validate(figure.pslg())
        except GeometryError:
            return False
        return True
    if figure.is_polygon:
        return is_simple(figure.points)
    points = figure.points
    if len(set(figure.places)) < len(figure.places) or len({frozenset(e) for e in figure.edges}) < len(figure.edges):
        return False
    for u, v in figure.edges:
        a, b = points[u], points[v]
        if any(turn(a, b, p) == 0 and is_between(p, a, b) for w, p in enumerate(figure.places) if w not in (u, v)):
            return False
    return not any(segments_meet(points[e[0]], points[e[1]], points[f[0]], points[f[1]])
                   for e, f in combinations(figure.edges, 2) if not set(e) & set(f))


def normal_form(figure: Figure) -> Figure:
    """Return the figure moved into the corner of the first quadrant: a polygon counter-clockwise from its least corner,
    any other figure with its points and edges sorted. A single cycle becomes a polygon."""
    if not figure.points:
        return figure
    if (corners := _as_cycle(figure)) is not None:
        return Figure.polygon(normalised(corners))
    left, low = min(x for x, _ in figure.points), min(y for _, y in figure.points)
    moved = [(x - left, y - low) for x, y in figure.points]
    order = sorted(range(len(moved)), key=moved.__getitem__)
    new = {old: i for i, old in enumerate(order)}
    edges = sorted((min(new[u], new[v]), max(new[u], new[v])) for u, v in figure.edges)
    return Figure(tuple(moved[i] for i in order), tuple(edges), tuple(sorted((x - left, y - low)
                                                                            for x, y in figure.holes)))


def images_of(figure: Figure) -> Iterator[Figure]:
    """Yield the eight images under the symmetries of the square, in normal form; some may be equal."""
    for flip_x, flip_y, swap in ((a, b, c) for a in (1, -1) for b in (1, -1) for c in (False, True)):
        moved = [(flip_x * x, flip_y * y) for x, y in figure.places]
        yield normal_form(figure.at([(y, x) for x, y in moved] if swap else moved))


def divided(figure: Figure) -> Figure:
    """Return the normal form divided by the greatest common divisor of its coordinates."""
    here = normal_form(figure)
    common = gcd(*(c for place in here.places for c in place)) or 1
    return here.at([(x // common, y // common) for x, y in here.places])


def complexity(figure: Figure) -> tuple[object, ...]:
    """Return what shrinking reduces: points, then edges and hole points, bits, the sum of coordinates, then the rest
    for a total order. Coordinates are not negative."""
    numbers = [c for place in figure.places for c in place]
    return (len(figure.points), len(figure.edges) + len(figure.holes), sum(c.bit_length() for c in numbers),
            sum(numbers), figure.points, figure.edges, figure.holes)


def _as_cycle(figure: Figure) -> Corners | None:
    """Return the points in order if the edges form one cycle through all of them and there are no hole points."""
    if figure.is_polygon:
        return figure.points
    count = len(figure.points)
    if figure.holes or count < 3 or len(figure.edges) != count:
        return None
    beside: list[list[int]] = [[] for _ in range(count)]
    for u, v in figure.edges:
        beside[u].append(v)
        beside[v].append(u)
    if any(len(pair) != 2 for pair in beside):
        return None
    walk = [0]
    before, at = 0, beside[0][0]
    while at != 0:
        walk.append(at)
        first, second = beside[at]
        before, at = at, second if first == before else first
    return tuple(figure.points[v] for v in walk) if len(walk) == count else None


def _scaled(points: Iterable[Point], scale: int) -> Corners:
    return tuple((int(p.x * scale), int(p.y * scale)) for p in points)


def _pairs(value: Iterable[Sequence[Any]]) -> Corners:
    return tuple((int(x), int(y)) for x, y in value)
