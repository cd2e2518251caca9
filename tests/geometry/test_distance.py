"""Squared distances: every point and segment of a small grid, laws, and segments of 10^40."""

from collections.abc import Callable
from fractions import Fraction
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.geometry.distance import distance_squared, line_distance_squared, segment_distance_squared
from exactmesh.geometry.point import Point, cross, dot, minus

few = settings(max_examples=200, deadline=None, derandomize=True)
GRID = [Point(mpq(x), mpq(y)) for x, y in product(range(4), repeat=2)]


def at(x: int | str, y: int | str) -> Point:
    return Point(mpq(x), mpq(y))


def points() -> st.SearchStrategy[Point]:
    number = st.one_of(
        st.integers(-3, 3).map(mpq),
        st.builds(lambda a, b: mpq(a) + mpq(b, 10**40), st.integers(-3, 3), st.integers(-2, 2)),
        st.builds(mpq, st.integers(-(10**30), 10**30), st.integers(1, 10**30)))
    return st.builds(Point, number, number)


def least_of_the_parabola(p: Point, a: Point, b: Point) -> Fraction:
    """Return the minimum of |a + t (b - a) - p|^2 over t in [0, 1], by its vertex clipped to the interval."""
    (px, py), (ax, ay), (bx, by) = (tuple(Fraction(int(v.numerator), int(v.denominator)) for v in q)
                                    for q in (p, a, b))
    u, v, w, z = bx - ax, by - ay, ax - px, ay - py
    quadratic, linear, constant = u * u + v * v, 2 * (u * w + v * z), w * w + z * z
    t = min(max(-linear / (2 * quadratic), Fraction(0)), Fraction(1)) if quadratic else Fraction(0)
    return quadratic * t * t + linear * t + constant


def test_every_point_and_segment_of_a_grid_have_the_least_distance_over_the_segment() -> None:
    for p, a, b in product(GRID, repeat=3):
        assert segment_distance_squared(p, a, b) == least_of_the_parabola(p, a, b)


def test_a_segment_of_a_grid_is_at_distance_zero_from_its_own_points_only() -> None:
    for p, a, b in product(GRID, repeat=3):
        between = cross(minus(p, a), minus(b, a)) == 0 and dot(minus(p, a), minus(p, b)) <= 0
        assert (segment_distance_squared(p, a, b) == 0) == between


def test_a_line_is_nearer_than_its_segments_and_its_foot_lies_on_it() -> None:
    for p, a, b in product(GRID, repeat=3):
        if a == b:
            with pytest.raises(ZeroDivisionError):
                line_distance_squared(p, a, b)
            continue
        direction = minus(b, a)
        t = dot(direction, minus(p, a)) / dot(direction, direction)
        foot = Point(a.x + t * direction.x, a.y + t * direction.y)
        squared = line_distance_squared(p, a, b)
        assert squared == distance_squared(p, foot)
        segment = segment_distance_squared(p, a, b)
        assert segment == squared if 0 <= t <= 1 else segment > squared


@few
@given(points(), points(), points())
@example(at(0, "1e-40"), at("-1e40", 0), at("1e40", 0))
@example(at(1, 0), at(0, 0), at("999999999999999999999999999999/1000000000000000000000000000000", 0))
def test_reversing_the_segment_changes_nothing_and_the_oracle_agrees(p: Point, a: Point, b: Point) -> None:
    squared = segment_distance_squared(p, a, b)
    assert squared == segment_distance_squared(p, b, a) == least_of_the_parabola(p, a, b)
    assert squared <= min(distance_squared(p, a), distance_squared(p, b))
    if a != b:
        assert line_distance_squared(p, a, b) == line_distance_squared(p, b, a) <= squared


@pytest.mark.parametrize(("move", "factor"), [
    (lambda p: Point(p.x + mpq(10**50, 7), p.y - mpq(1, 10**50)), mpq(1)),
    (lambda p: Point(-p.x, p.y), mpq(1)),
    (lambda p: Point(p.y, p.x), mpq(1)),
    (lambda p: Point((3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5), mpq(1)),
    (lambda p: Point(p.x / 10**35, p.y / 10**35), mpq(1, 10**70)),
], ids=["moved", "mirrored", "transposed", "turned", "shrunk"])
@few
@given(p=points(), a=points(), b=points())
def test_a_similarity_scales_distances(move: Callable[[Point], Point], factor: mpq, p: Point, a: Point,
                                       b: Point) -> None:
    image = move(p), move(a), move(b)
    assert segment_distance_squared(*image) == factor * segment_distance_squared(p, a, b)
    assert distance_squared(image[0], image[1]) == factor * distance_squared(p, a)
    if a != b:
        assert line_distance_squared(*image) == factor * line_distance_squared(p, a, b)


def test_a_distance_of_10_to_minus_40_beside_a_segment_of_10_to_40_is_exact() -> None:
    assert segment_distance_squared(at(0, "1e-40"), at("-1e40", 0), at("1e40", 0)) == mpq(1, 10**80)
    # (0, 0) from x + 10^40 y = 1: 1 / (1 + 10^80).
    a, b = at(1, 0), at(1 - 10**40, 1)
    assert segment_distance_squared(at(0, 0), a, b) == mpq(1, 1 + 10**80)
