"""The predicates: every triple of a small grid against the definition, laws, and nasty rationals."""

from collections.abc import Callable
from fractions import Fraction
from itertools import permutations, product

import pytest
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.geometry.point import Point, cross, dot, minus
from exactmesh.geometry.predicates import (
    doubled_area,
    is_ahead,
    is_between,
    line_crossing,
    orientation,
    x_at,
)

few = settings(max_examples=200, deadline=None, derandomize=True)
GRID = [Point(mpq(x), mpq(y)) for x, y in product(range(4), repeat=2)]
PARITY = {order: (1 if sum(order[i] > order[j] for i in range(3) for j in range(i + 1, 3)) % 2 == 0 else -1)
          for order in permutations(range(3))}


def at(x: int | str, y: int | str) -> Point:
    return Point(mpq(x), mpq(y))


def rationals() -> st.SearchStrategy[mpq]:
    """Small ones, ones that differ in the 40th digit, and ones of 60 digits."""
    small = st.integers(-3, 3).map(mpq)
    near = st.builds(lambda a, b: mpq(a) + mpq(b, 10**40), st.integers(-3, 3), st.integers(-2, 2))
    big = st.builds(mpq, st.integers(-(10**30), 10**30), st.integers(1, 10**30))
    return st.one_of(small, near, big)


def points() -> st.SearchStrategy[Point]:
    return st.builds(Point, rationals(), rationals())


def shoelace(a: Point, b: Point, c: Point) -> Fraction:
    """Return twice the signed area by another formula, in other numbers."""
    xs, ys = ([Fraction(int(v.numerator), int(v.denominator)) for v in p] for p in zip(a, b, c, strict=True))
    return sum((xs[i - 1] * ys[i] - xs[i] * ys[i - 1] for i in range(3)), Fraction(0))


def sgn(value: Fraction | mpq) -> int:
    return (value > 0) - (value < 0)


def test_every_triple_of_a_grid_has_the_orientation_of_the_shoelace_formula() -> None:
    for a, b, c in product(GRID, repeat=3):
        area = shoelace(a, b, c)
        assert doubled_area(a, b, c) == area
        assert orientation(a, b, c) == sgn(area)


def test_every_triple_of_a_grid_goes_ahead_when_the_product_of_its_steps_is_positive() -> None:
    for a, b, c in product(GRID, repeat=3):
        assert is_ahead(a, b, c) is bool(dot(minus(b, a), minus(c, b)) > 0)
        assert is_ahead(a, b, c) == is_ahead(c, b, a)


def test_between_is_being_a_convex_combination_on_every_collinear_triple_of_a_grid() -> None:
    parts = [mpq(i, 6) for i in range(7)]  # a grid of four has no other ratios than multiples of 1/2, 1/3
    for a, b in product(GRID, repeat=2):
        segment = {Point(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t) for t in parts}
        for p in GRID:
            if orientation(a, p, b) == 0:
                assert is_between(a, p, b) == (p in segment) == is_between(b, p, a)


def test_every_two_lines_through_a_grid_cross_on_both_or_are_refused_as_parallel() -> None:
    lines = [(a, b) for i, a in enumerate(GRID[:12]) for b in GRID[i + 1:]]
    for (a, b), (c, d) in product(lines, lines[::5]):
        if cross(minus(b, a), minus(d, c)) == 0:
            with pytest.raises(ZeroDivisionError):
                line_crossing(a, b, c, d)
        else:
            p = line_crossing(a, b, c, d)
            assert orientation(a, b, p) == 0 == orientation(c, d, p)


def test_x_at_lies_on_the_line_at_the_asked_height() -> None:
    for a, b in product(GRID, repeat=2):
        if a.y != b.y:
            for y in (mpq(-7, 3), mpq(0), mpq(1, 2), mpq(3)):
                assert orientation(a, b, Point(x_at(a, b, y), y)) == 0
    with pytest.raises(ZeroDivisionError):
        x_at(at(0, 1), at(5, 1), mpq(1))


@few
@given(points(), points(), points())
@example(at(0, 0), at(1, 1), at("1/3", "1/3"))
@example(at(0, 0), at(10**40, 1), at(2 * 10**40, 2))
@example(at(0, 0), at(10**40, 1), at(2 * 10**40 + 1, 2))
def test_a_permutation_changes_the_orientation_by_its_parity(a: Point, b: Point, c: Point) -> None:
    given_order = orientation(a, b, c)
    assert given_order == sgn(shoelace(a, b, c))
    for order, parity in PARITY.items():
        assert orientation(*((a, b, c)[i] for i in order)) == parity * given_order


def moved(p: Point) -> Point:
    return Point(p.x + mpq(10**50, 3), p.y - mpq(1, 10**50))


def mirrored(p: Point) -> Point:
    return Point(-p.x, p.y)


def shrunk(p: Point) -> Point:
    return Point(p.x / 10**35, p.y / 10**35)


def turned(p: Point) -> Point:
    return Point((3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5)


@pytest.mark.parametrize(("move", "factor", "turns"), [
    (moved, mpq(1), 1), (mirrored, mpq(1), -1), (shrunk, mpq(1, 10**70), 1), (turned, mpq(1), 1)])
@few
@given(a=points(), b=points(), c=points())
def test_areas_are_kept_mirrored_or_scaled_and_directions_kept(
        move: Callable[[Point], Point], factor: mpq, turns: int, a: Point, b: Point, c: Point) -> None:
    image = move(a), move(b), move(c)
    assert doubled_area(*image) == turns * factor * doubled_area(a, b, c)
    assert orientation(*image) == turns * orientation(a, b, c)
    assert is_ahead(*image) == is_ahead(a, b, c)


@few
@given(points(), points())
def test_coinciding_arguments_are_collinear_and_stand_still(a: Point, b: Point) -> None:
    assert orientation(a, a, b) == orientation(a, b, b) == orientation(b, a, b) == 0
    assert not is_ahead(a, a, b) and not is_ahead(a, b, b)
    assert is_between(a, a, b) and is_between(a, b, b)


def test_a_point_is_printed_exactly() -> None:
    assert str(at("1/3", "-7")) == "(1/3, -7)"
