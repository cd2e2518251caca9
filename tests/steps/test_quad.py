"""Quadrilaterals without T-vertices: hand cases, and every result tiles and is the best one offered."""

from itertools import pairwise

import pytest
from constructions import face_feature_squared, point, untiled
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.constants import FEATURE_SQUARED, LEVEL
from exactmesh.steps.quad import centre_value, centres, fan_about, quad

numbers = st.fractions(min_value=-6, max_value=6, max_denominator=7)
laws = settings(max_examples=150, derandomize=True, deadline=None)
SQUARE = (point(0, 0), point(2, 0), point(2, 2), point(0, 2))


@st.composite
def trapezoids(draw):
    """Return a trapezoid between two levels, at most one side a point."""
    xs = [sorted(draw(st.tuples(numbers, numbers))) for _ in range(2)]
    height = draw(st.fractions(min_value=1, max_value=9, max_denominator=4)) * LEVEL
    (a, b), (c, d) = xs
    assume(a < b or c < d)
    return point(a, 0), point(b, 0), point(d, height), point(c, height)


def placed(corners, piece):
    """Return the points and the faces of a piece with new vertices numbered after the corners."""
    return [*corners, *piece.steiner], [tuple(v if v >= 0 else 3 - v for v in face) for face in piece.faces]


def tiles(corners, piece):
    """Return whether the faces tile the quadrilateral."""
    points, faces = placed(corners, piece)
    return untiled(points, (0, 1, 2, 3), faces) == []


def value_of(corners, piece):
    """Return the least squared feature size of the faces."""
    points, faces = placed(corners, piece)
    return min(face_feature_squared(points, face) for face in faces)


def test_a_square_gets_a_diagonal():
    assert quad(SQUARE).faces == ((0, 1, 2), (0, 2, 3)) and quad(SQUARE).steiner == ()


def test_the_better_diagonal_is_taken():
    leaning = (point(0, 0), point(2, 0), point(5, 2), point(3, 2))
    assert quad(leaning).faces == ((0, 1, 3), (1, 2, 3))
    assert quad([Point(-p.x, p.y) for p in (leaning[1], leaning[0], leaning[3], leaning[2])]).faces == (
        (0, 1, 2), (0, 2, 3))


@pytest.mark.parametrize("dent", range(4))
def test_a_diagonal_outside_loses(dent):
    # A square with one corner pushed in beyond the middle: only the diagonal from that corner is inside.
    corners = list(SQUARE)
    corners[dent] = point(1 + mpq(corners[dent].x - 1, 5) * -1, 1 + mpq(corners[dent].y - 1, 5) * -1)
    piece = quad(corners)
    assert all(dent in face for face in piece.faces) and tiles(corners, piece)


@pytest.mark.parametrize("merged", range(4))
def test_two_corners_in_one_place_leave_a_triangle(merged):
    corners = list(SQUARE)
    corners[merged] = corners[merged - 1]
    (face,) = quad(corners).faces
    assert len(face) == 3 and merged not in face and quad(corners).steiner == ()


@pytest.mark.parametrize("corners", [(0, 0, 2, 2), (0, 0, 0, 0), (1, 2, 2, 1)])
def test_fewer_corners_leave_nothing(corners):
    assert quad([SQUARE[v] for v in corners]).faces == ()


@pytest.mark.parametrize("left", ["3/10", "1", "2", "37/10"])
def test_a_centre_is_taken_where_both_diagonals_are_flat(left):
    # A low trapezoid with a very short top: either diagonal leaves a flat triangle at the top.
    corners = (point(0, 0), point(4, 0), point(mpq(left) + mpq(3, 50), LEVEL), point(left, LEVEL))
    piece = quad(corners)
    assert len(piece.steiner) == 1 and len(piece.faces) == 4 and tiles(corners, piece)
    assert value_of(corners, piece) >= FEATURE_SQUARED


def test_a_diagonal_is_kept_when_no_centre_is_better():
    # No centre of a square beats the height sqrt(2) of the halves, however much is wanted.
    assert quad(SQUARE, mpq(100)).steiner == ()


@laws
@given(trapezoids())
def test_every_trapezoid_is_tiled(corners):
    distinct = [i for i in range(4) if corners[i] != corners[i - 1]]
    points, faces = placed(corners, quad(corners))
    assert untiled(points, distinct, faces) == []


@laws
@given(trapezoids(), st.sampled_from([FEATURE_SQUARED, mpq(100)]))
def test_nothing_that_was_offered_is_better_than_what_is_too_small(corners, wanted):
    assume(len(set(corners)) == 4)
    value = value_of(corners, quad(corners, wanted))
    offered = [centre_value(corners, centre) for centre in centres(corners)]
    for faces in (((0, 1, 2), (0, 2, 3)), ((0, 1, 3), (1, 2, 3))):
        # A trapezoid is convex, so both diagonals are inside.
        diagonal = min(face_feature_squared(corners, face) for face in faces)
        assert value >= diagonal
    assert value >= wanted or value >= max(offered)


@laws
@given(trapezoids(), st.fractions(max_denominator=50), st.fractions(max_denominator=50))
def test_moving_the_corners_moves_the_piece(corners, dx, dy):
    moved = [Point(p.x + mpq(dx), p.y + mpq(dy)) for p in corners]
    piece, other = quad(corners), quad(moved)
    assert other.faces == piece.faces
    assert other.steiner == tuple(Point(p.x + mpq(dx), p.y + mpq(dy)) for p in piece.steiner)


def test_the_centres_are_those_of_the_rule():
    found = list(centres((point(0, 0), point(4, 0), point(3, 2), point(1, 2))))
    assert found == [point(2, 1), *(point(2, mpq(k, 10) * 2) for k in (3, 5, 7)),
                     *(point(2, 2 - mpq(k, 10) * 2) for k in (3, 5, 7))]


def test_an_apex_has_centres_above_its_side_only():
    assert len(list(centres((point(0, 0), point(4, 0), point(2, 2), point(2, 2))))) == 4


def test_a_fan_goes_round():
    piece = fan_about(5, point(1, 1))
    assert piece.faces == ((0, 1, -1), (1, 2, -1), (2, 3, -1), (3, 4, -1), (4, 0, -1))
    assert all(a[1] == b[0] for a, b in pairwise(piece.faces))


@laws
@given(trapezoids(), numbers, numbers)
def test_the_value_of_a_centre_is_signed(corners, x, y):
    centre = point(x, y)
    inside = all(corners[i - 1] == corners[i] or doubled_area(corners[i - 1], corners[i], centre) > 0
                 for i in range(4))
    assume(len(set(corners)) == 4)
    assert (centre_value(corners, centre) > 0) == inside
