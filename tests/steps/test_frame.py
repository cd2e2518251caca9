"""The frame: what it keeps, its way back, and the height of the clean side."""

from fractions import Fraction

import pytest
from constructions import point
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.frame import Frame, frame_of

numbers = st.fractions(min_value=-9, max_value=9, max_denominator=12)
points = st.builds(point, numbers, numbers)
laws = settings(max_examples=150, derandomize=True, deadline=None)


@st.composite
def frames(draw):
    """Return a frame and what it is made from."""
    start, end, a, b = draw(st.tuples(points, points, points, points))
    assume(start != end)
    shares = sorted(draw(st.sets(st.integers(1, 99), max_size=5)))
    t_side = [start, *(Point(start.x + (end.x - start.x) * mpq(k, 100), start.y + (end.y - start.y) * mpq(k, 100))
                       for k in shares), end]
    return frame_of(t_side, a, b), t_side, a, b


def test_a_level_t_side_below_its_anchors():
    frame = frame_of([point(1, 1), point(2, 1), point(3, 1)], point(1, 4), point(3, 4))
    assert frame.u == (0, mpq(1, 2), 1) and not frame.mirrored
    assert frame.a == (0, mpq(3, 2)) and frame.b == (1, mpq(3, 2))
    assert frame.scale_squared == mpq(1, 4) and (frame.left, frame.right) == (3, 4)
    assert frame.points() == [(0, 0), (mpq(1, 2), 0), (1, 0), (0, mpq(3, 2)), (1, mpq(3, 2))]


def test_a_level_t_side_above_its_anchors_is_mirrored():
    frame = frame_of([point(1, 1), point(3, 1)], point(1, -2), point(3, -2))
    assert frame.mirrored and frame.a == (0, mpq(3, 2)) and frame.b == (1, mpq(3, 2))


def test_the_area_decides_the_side_and_not_one_anchor():
    # A lies below the T-side, but the quadrilateral is above it.
    frame = frame_of([point(0, 0), point(9, 0)], point(-1, "-1/10"), point(9, 3))
    assert not frame.mirrored and frame.a.y < 0 < frame.b.y


def test_a_quadrilateral_without_area_is_not_mirrored():
    assert not frame_of([point(0, 0), point(9, 0)], point(1, 0), point(5, 0)).mirrored
    assert not frame_of([point(0, 0), point(9, 0)], point(9, 2), point(0, 2)).mirrored


@laws
@given(frames())
def test_lengths_are_divided_by_the_length_of_the_t_side(given_frame):
    frame, t_side, a, b = given_frame
    found, places = frame.points(), [*t_side, a, b]
    assert frame.scale_squared == 1 / distance_squared(t_side[0], t_side[-1])
    for p, q in zip(found, places, strict=True):
        for r, s in zip(found, places, strict=True):
            assert distance_squared(p, r) == frame.scale_squared * distance_squared(q, s)
    turned = -1 if frame.mirrored else 1
    assert doubled_area(found[0], found[-1], found[-2]) == (
        turned * frame.scale_squared * doubled_area(t_side[0], b, a))


@laws
@given(frames())
def test_the_quadrilateral_lies_above(given_frame):
    frame, *_ = given_frame
    u, a, b = frame.u[-1], frame.a, frame.b
    doubled = u * b.y + (b.x * a.y - b.y * a.x)
    assert doubled >= 0
    assert frame.u == tuple(sorted(frame.u)) and frame.u[0] == 0


@laws
@given(frames())
def test_the_way_back_finds_every_point_again(given_frame):
    frame, t_side, a, b = given_frame
    piece = frame.piece([(0, 1, 2)], frame.points())
    assert list(piece.steiner) == [*t_side, a, b]
    assert piece.faces == (((2, 1, 0),) if frame.mirrored else ((0, 1, 2),))


@laws
@given(frames())
def test_swapping_the_ends_reflects_the_frame(given_frame):
    frame, t_side, a, b = given_frame
    other = frame_of(t_side[::-1], b, a)
    length = frame.u[-1]
    assert other.u == tuple(length - u for u in reversed(frame.u))
    if frame.mirrored != other.mirrored:
        assert (other.a, other.b) == (Point(length - frame.b.x, frame.b.y), Point(length - frame.a.x, frame.a.y))


def frame_with(u_last, a, b):
    return Frame((mpq(0), mpq(u_last)), point(*a), point(*b), point(0, 0), point(1, 0), False)


@pytest.mark.parametrize("a, b, height", [
    ((0, 3), (10, 3), 3),          # level
    ((0, 3), (10, 5), 3),          # slanted, A lower
    ((0, 5), (10, 3), 3),          # slanted, B lower
    ((-10, 1), (10, 5), 3),        # A beyond the T-side: the height counts above it only
    ((5, 1), (20, 4), 1),          # B beyond
    ((-10, 0), (20, 6), 2),        # both beyond
    ((5, 4), (5, 2), 2),           # the clean side stands upright
    ((-9, 4), (-3, 2), 0),         # nothing of the T-side is below the clean side
    ((12, 4), (15, 2), 0),
    ((10, 4), (3, 2), 2),          # the anchors have changed places
    ((-5, -1), (15, 3), 0),        # no height at the start of the T-side
    ((-5, -2), (15, 3), Fraction(-3, 4)),
])
def test_the_height_of_the_clean_side(a, b, height):
    assert frame_with(10, a, b).clean_height() == mpq(height)


@laws
@given(frames())
def test_the_height_is_the_least_over_a_sample_of_the_t_side(given_frame):
    frame, *_ = given_frame
    a, b = frame.a, frame.b
    assume(a.x != b.x)
    slope = (b.y - a.y) / (b.x - a.x)
    over = [mpq(k, 16) * frame.u[-1] for k in range(17)]
    heights = [a.y + slope * (x - a.x) for x in over if min(a.x, b.x) <= x <= max(a.x, b.x)]
    assert all(frame.clean_height() <= height for height in heights)
