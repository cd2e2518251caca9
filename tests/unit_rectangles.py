"""Triangulated unit rectangles as a Tube of one rectangle, for the Tube's checkers."""

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.records import PaperTube, Patch, Rectangle, UnitPiece

HEIGHTS = (mpq(1, 4), mpq(1), mpq(2), mpq(8))


def tube_of(positions: Sequence[int], height: mpq, fill: Callable[[Sequence[int]], UnitPiece]
            ) -> tuple[PaperTube, list[Point]]:
    """Return the rectangle of spacing 1 and this height, filled, with its points: b is (0, 0), b' is (0, height)."""
    unit = fill(positions)
    m = len(positions) - 1
    points = [Point(mpq(u), mpq(0)) for u in positions] + [Point(mpq(0), height), Point(mpq(positions[-1]), height)]
    steiner = [Point(p.x, p.y * height) for p in unit.steiner]
    faces = tuple(tuple(v if v >= 0 else len(points) - 1 - v for v in face) for face in unit.faces)
    record = Rectangle(0, tuple(range(m + 1)), tuple(positions), m + 2, m + 1)
    tube = PaperTube(Patch(len(points), tuple(steiner), faces), ("rectangle",) * len(faces), (record,))
    return tube, points + steiner


def subsets(longest: int) -> Iterator[list[int]]:
    """Yield all lists of positions 0 < .. < c with at least one inner one, for c up to `longest`."""
    for c in range(2, longest + 1):
        for count in range(1, c):
            for inner in combinations(range(1, c), count):
                yield [0, *inner, c]
