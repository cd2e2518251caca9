"""Small polygons: the triangulation is the best of all, and it tiles."""

from collections.abc import Iterator

import oracle
import pytest
from constructions import graph, lattice_polygon, untiled

from exactmesh.geometry.point import Point
from exactmesh.steps.heights import height_squared
from exactmesh.steps.records import Cycle
from exactmesh.steps.small_polygon import triangulate_small


def all_triangulations(i: int, j: int) -> Iterator[tuple[Cycle, ...]]:
    """Yield every way to cut the vertices i to j into triangles, overlapping ones as well."""
    if j == i + 1:
        yield ()
    for k in range(i + 1, j):
        for left in all_triangulations(i, k):
            for right in all_triangulations(k, j):
                yield ((i, k, j), *left, *right)


def least_height(points: list[Point], faces: tuple[Cycle, ...]) -> oracle.Fraction:
    """Return the least signed squared height of the faces."""
    return oracle.exact(min(height_squared(*(points[v] for v in face)) for face in faces))


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7])
def test_it_is_the_best_of_all_triangulations(n: int) -> None:
    for seed in range(40):
        points = list(lattice_polygon(n, 3 + seed % 4, seed).vertices)
        faces = triangulate_small(points)
        tiling = [t for t in all_triangulations(0, n - 1) if untiled(points, range(n), t) == []]
        assert untiled(points, range(n), faces) == []
        assert least_height(points, faces) == max(least_height(points, t) for t in tiling)


def test_no_triangulation_that_overlaps_itself_counts() -> None:
    # Every way to cut the indices, valid or not: those that leave the polygon have a triangle that turns right.
    for seed in range(20):
        points = list(lattice_polygon(6, 5, seed).vertices)
        for faces in all_triangulations(0, 5):
            assert (untiled(points, range(6), faces) == []) == (least_height(points, faces) > 0)


def test_vertices_within_straight_sides_get_diagonals() -> None:
    points = list(graph([(0, 0), (1, 0), (2, 0), (3, 0), (3, 2), (2, 2), (0, 2)]).vertices)
    faces = triangulate_small(points)
    assert untiled(points, range(7), faces) == [] and len(faces) == 5


def test_the_numbering_does_not_matter() -> None:
    for seed in range(10):
        points = list(lattice_polygon(7, 6, seed).vertices)
        values = {least_height(turned, triangulate_small(turned))
                  for turned in (points[i:] + points[:i] for i in range(7))}
        assert len(values) == 1
