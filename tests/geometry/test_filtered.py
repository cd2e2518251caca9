"""The float filter: always the exact sign, and the path that decided is known."""

import random
from itertools import permutations, product

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.geometry.filtered import FilteredPoints, unit_floats
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area, orientation

few = settings(max_examples=150, deadline=None, derandomize=True)


def decided(points: list[Point], i: int = 0, j: int = 1, k: int = 2) -> tuple[int, bool]:
    """Return the orientation of three of the points and whether the exact predicate was needed."""
    filtered = FilteredPoints(points)
    return filtered.orientation(i, j, k), filtered.decided_exactly == 1


def rationals() -> st.SearchStrategy[mpq]:
    small = st.integers(-3, 3).map(mpq)
    near = st.builds(lambda a, b, e: mpq(a) + mpq(b) / mpq(10) ** e, st.integers(-3, 3), st.integers(-2, 2),
                     st.integers(1, 40))
    big = st.builds(mpq, st.integers(-(10**30), 10**30), st.integers(1, 10**30))
    return st.one_of(small, near, big)


def test_every_triple_of_a_grid_is_decided_right_and_only_collinear_ones_exactly() -> None:
    grid = [Point(mpq(x), mpq(y)) for x, y in product(range(4), repeat=2)]
    filtered = FilteredPoints(grid)
    collinear = 0
    for i, j, k in product(range(16), repeat=3):
        exact = orientation(grid[i], grid[j], grid[k])
        assert filtered.orientation(i, j, k) == exact
        collinear += exact == 0
        assert filtered.decided_exactly == collinear


@few
@given(st.lists(st.builds(Point, rationals(), rationals()), min_size=3, max_size=6))
def test_the_sign_is_exact_for_nasty_rationals(points: list[Point]) -> None:
    filtered = FilteredPoints(points)
    for triple in permutations(range(len(points)), 3):
        assert filtered.orientation(*triple) == orientation(*(points[i] for i in triple))


@pytest.mark.parametrize("exponent", [12, 14])
def test_what_floats_can_tell_is_told_by_floats(exponent: int) -> None:
    third = Point(mpq(1, 3), mpq(1, 3) + mpq(1, 10**exponent))
    points = [Point(mpq(0), mpq(0)), Point(mpq(1), mpq(1)), third]
    assert decided(points) == (1, False)


@pytest.mark.parametrize("exponent", [16, 17, 18, 30, 300])
@pytest.mark.parametrize("side", [-1, 0, 1])
def test_near_degenerate_triples_are_decided_exactly(exponent: int, side: int) -> None:
    third = Point(mpq(1, 3), mpq(1, 3) + side * mpq(1, 10**exponent))
    points = [Point(mpq(0), mpq(0)), Point(mpq(1), mpq(1)), third]
    for i, j, k in permutations(range(3)):
        sign, exactly = decided(points, i, j, k)
        assert exactly and sign == orientation(points[i], points[j], points[k])


@few
@given(st.integers(-(2**60), 2**60), st.integers(-(2**60), 2**60), st.integers(-9, 9), st.integers(0, 4))
def test_points_beside_a_line_by_one_part_in_10_to_the_17(x: int, y: int, off: int, e: int) -> None:
    a, b = Point(mpq(0), mpq(0)), Point(mpq(x), mpq(y))
    middle = Point(mpq(x, 3), mpq(y, 3) + mpq(off) * max(abs(x), abs(y), 1) / 10 ** (15 + e))
    points = [a, b, middle]
    assert FilteredPoints(points).orientation(0, 1, 2) == orientation(a, b, middle)


@pytest.mark.parametrize("offset", [mpq(0), mpq(10**17), mpq(10**300, 7), mpq(-(10**1000), 3)])
@pytest.mark.parametrize("scale", [mpq(1), mpq(1, 10**40), mpq(10**400)])
def test_huge_offsets_and_scales_do_not_send_plain_triples_to_the_exact_path(offset: mpq, scale: mpq) -> None:
    corners = [(0, 0), (5, 1), (2, 7), (6, 3)]
    points = [Point(offset + scale * x, -offset + scale * y) for x, y in corners]
    filtered = FilteredPoints(points)
    for i, j, k in permutations(range(4), 3):
        assert filtered.orientation(i, j, k) == orientation(points[i], points[j], points[k]) != 0
    assert filtered.decided_exactly == 0


def test_collinear_points_that_floats_see_beside_their_line_are_decided_exactly() -> None:
    # The frame makes the scale 1, so that coordinates near the frame are rounded as coarsely as any.
    frame = [Point(mpq(sign * 511, 512), mpq(sign * 511, 512)) for sign in (-1, 1)]
    source = random.Random(1)
    for _ in range(3000):
        a, b = (mpq(source.randint(700, 997) * source.choice((1, -1)), 1000) for _ in range(2))
        points = [Point(a * t, b * t) for t in (mpq(source.randint(-997, 997), 999) for _ in range(3))]
        assert decided([*points, *frame]) == (0, True)


def test_a_cluster_below_the_resolution_of_floats_is_decided_exactly() -> None:
    tiny = mpq(1, 10**60)
    points = [Point(mpq(0), mpq(0)), Point(tiny, mpq(0)), Point(mpq(0), tiny), Point(mpq(1), mpq(1))]
    assert decided(points) == (1, True)
    assert decided(points, 0, 2, 1) == (-1, True)


def test_coinciding_indices_are_collinear() -> None:
    points = [Point(mpq(0), mpq(0)), Point(mpq(1, 3), mpq(1)), Point(mpq(2), mpq(1, 7))]
    filtered = FilteredPoints(points)
    assert all(filtered.orientation(*triple) == 0 for triple in [(0, 0, 1), (0, 1, 1), (1, 0, 1), (2, 2, 2)])


@few
@given(st.lists(st.builds(Point, rationals(), rationals()), min_size=1, max_size=8))
def test_unit_floats_are_within_their_bound_of_the_moved_and_scaled_points(points: list[Point]) -> None:
    xs, ys, scale = unit_floats(points)
    power = scale.numerator * scale.denominator
    assert power & (power - 1) == 0 and scale > 0
    x0 = (min(p.x for p in points) + max(p.x for p in points)) / 2
    y0 = (min(p.y for p in points) + max(p.y for p in points)) / 2
    for p, x, y in zip(points, xs, ys, strict=True):
        assert abs(x) <= 1 and abs(y) <= 1
        assert abs(mpq(x) - (p.x - x0) / scale) <= mpq(1, 2**52)
        assert abs(mpq(y) - (p.y - y0) / scale) <= mpq(1, 2**52)


def test_unit_floats_of_nothing_and_of_one_point() -> None:
    assert unit_floats([]) == ([], [], 1)
    assert unit_floats([Point(mpq(7, 3), mpq(-(10**50)))]) == ([0.0], [0.0], 1)


def test_the_bound_covers_the_error_of_the_rounded_determinant() -> None:
    # Coordinates at odd multiples of a quarter of an ulp, where rounding errs most.
    quarter = mpq(1, 2**54)
    worst = mpq(0)
    for a, b, c, d in product((1, 3, 5), repeat=4):
        points = [Point(mpq(-1), mpq(-1)), Point(mpq(1), mpq(1)),
                  Point(mpq(1, 3) + a * quarter, mpq(2, 5) + b * quarter),
                  Point(mpq(-1, 5) - c * quarter, mpq(1, 7) + d * quarter)]
        xs, ys, scale = unit_floats(points)
        p, q, r, s = xs[2] - xs[1], ys[3] - ys[1], ys[2] - ys[1], xs[3] - xs[1]
        error = abs(mpq(p * q - r * s) - doubled_area(*points[1:]) / scale**2)
        assert error <= mpq(abs(p) + abs(q) + abs(r) + abs(s)) / 2**49
        worst = max(worst, error)
    assert worst > 0
