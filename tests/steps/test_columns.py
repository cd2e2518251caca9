"""Columns: every face has three vertices, and vertices are handed on from room to room down to the edges of Q."""

import families
import pytest
from constructions import cycle_area, points_of, rings_on_levels, run
from gmpy2 import mpq

from exactmesh.measure.face_feature import face_feature_squared
from exactmesh.steps.columns import triangulate_in_columns
from exactmesh.steps.constants import LEVEL, MERGE, TRIM
from exactmesh.steps.heights import height_squared
from exactmesh.steps.patch_check import check_interior_tiling
from exactmesh.steps.trapezoidation import trapezoidate

NAMES = [*sorted(families.ALL_SMALL | families.SMALL_PSLGS), "hall"]
# A tooth hangs to (10, 8) over a room that grows in steps on its right: chords on levels 2, 4 and 6.
STEPS = [(0, 0), (20, 0), (20, 2), (24, 2), (24, 4), (28, 4), (28, 6), (32, 6), (32, 12), (11, 12), (10, 8), (9, 12),
         (0, 12)]
STRIP = [(0, 0), (100, 1), (200, 2), (168, 2), (68, 1), (-32, 0)]
SQUARED_TRIANGLE = MERGE**2 * TRIM**2 / (MERGE**2 + TRIM**2)


def made(*rings):
    """Return offset, trapezoidation, points and the patch of rings on levels."""
    q = rings_on_levels(*rings)
    chords = trapezoidate(q)
    points = points_of(q, chords)
    patch = triangulate_in_columns(q, chords, points)
    return q, chords, [*points, *patch.points], patch


def least_height(points, patch):
    """Return the least squared height of the faces of a patch."""
    return min(height_squared(*(points[v] for v in face)) for face in patch.faces)


def levels_at(patch, x):
    """Return the levels of the new vertices with this abscissa."""
    return sorted(p.y / LEVEL - mpq(1, 2) for p in patch.points if p.x == x)


# --- hand cases ---


def test_a_rectangle_gets_a_diagonal():
    _, _, _, patch = made([(0, 0), (5, 0), (5, 3), (0, 3)])
    assert len(patch.faces) == 2 and patch.points == () and patch.on_edge == ()


def test_a_vertex_is_handed_on_through_every_chord():
    q, chords, points, patch = made(STEPS)
    assert check_interior_tiling(q, chords, patch, points).holds
    assert all(len(face) == 3 for face in patch.faces)
    assert levels_at(patch, 10) == [0, 2, 4, 6]
    on_edge = {v for _, v in patch.on_edge}
    assert {(points[v].x, points[v].y / LEVEL - mpq(1, 2)) for v in on_edge} >= {(10, 0)}


def test_a_vertex_is_handed_up_as_well():
    upside_down = [(x, -y) for x, y in STEPS][::-1]
    q, chords, points, patch = made(upside_down)
    assert check_interior_tiling(q, chords, patch, points).holds
    assert all(len(face) == 3 for face in patch.faces)
    assert levels_at(patch, 10) == [-6, -4, -2, 0]


def test_an_edge_ends_at_a_vertex_that_is_near():
    for shift, ends_there in ((MERGE / 2, True), (-MERGE, True), (2 * MERGE, False)):
        floor = 10 + shift
        ring = [(0, 0), (floor - 1, -4), (floor, 0), (floor + 1, -4), (20, 0), (20, 8), (11, 8), (10, 4), (9, 8),
                (0, 8)]
        q, chords, points, patch = made(ring)
        assert check_interior_tiling(q, chords, patch, points).holds
        assert (levels_at(patch, 10) == []) == ends_there


def test_no_vertex_near_two_legs():
    _, _, points, patch = made(STRIP)
    assert all(len(face) == 3 for face in patch.faces)
    # The strip is 0.32 levels high.
    assert least_height(points, patch) > (mpq(31, 100) * LEVEL) ** 2


# --- laws ---


@pytest.mark.parametrize("name", NAMES)
def test_the_columns_of_every_family(name):
    whole = run(name).construction
    q, chords = whole.offset, whole.trapezoidation
    points = [*whole.shape.points, *q.points, *chords.points]
    patch = triangulate_in_columns(q, chords, points)
    points += patch.points
    assert check_interior_tiling(q, chords, patch, points).holds
    assert all(len(face) == 3 for face in patch.faces)
    assert sum(cycle_area(points, face) for face in patch.faces) == sum(
        cycle_area(points, range(q.first + a, q.first + b)) for a, b in q.rings)
    # The flattest triangle that trimming and merging allow: legs MERGE and TRIM.
    for face in patch.faces:
        assert face_feature_squared(points, face, [0, 1, 2]) >= SQUARED_TRIANGLE
