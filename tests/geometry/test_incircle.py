"""The in-circle predicate: the sign from the circle's centre, and the path that decided."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import permutations, product
from typing import Any

import oracle
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.geometry.filtered import unit_floats
from exactmesh.geometry.incircle import CirclePoints, in_circle
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation

few = settings(max_examples=150, deadline=None, derandomize=True)


def point(x: object, y: object) -> Point:
    return Point(mpq(x), mpq(y))


def by_centre(a: Point, b: Point, c: Point, d: Point) -> int:
    """Return the sign by comparing the distances of a and d from the centre, on Fractions; a, b, c are in general
    position. Negative when they turn right."""
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = (oracle.place(p) for p in (a, b, c, d))
    ux, uy, vx, vy = bx - ax, by - ay, cx - ax, cy - ay
    area = 2 * (ux * vy - uy * vx)
    u, v = ux * ux + uy * uy, vx * vx + vy * vy
    x, y = (vy * u - uy * v) / area, (ux * v - vx * u) / area
    gap = x * x + y * y - (dx - ax - x) ** 2 - (dy - ay - y) ** 2
    return ((gap > 0) - (gap < 0)) * (1 if area > 0 else -1)


def lifted(p: Sequence[Any], q: Sequence[Any], r: Sequence[Any]) -> Any:
    """Return the polynomial of the predicate in the order in which it is evaluated, on any numbers."""
    (ax, ay), (bx, by), (cx, cy) = p, q, r
    return ((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax)
            + (cx * cx + cy * cy) * (ax * by - ay * bx))


def rationals() -> st.SearchStrategy[mpq]:
    small = st.integers(-3, 3).map(mpq)
    near = st.builds(lambda a, b, e: mpq(a) + mpq(b) / mpq(10) ** e, st.integers(-3, 3), st.integers(-2, 2),
                     st.integers(1, 40))
    big = st.builds(mpq, st.integers(-(10**30), 10**30), st.integers(1, 10**30))
    return st.one_of(small, near, big)


def test_every_four_points_of_a_grid_are_decided_right_and_only_those_on_one_circle_exactly() -> None:
    grid = [point(x, y) for x, y in product(range(4), repeat=2)]
    circles = CirclePoints(grid)
    exactly = 0
    for i, j, k, m in product(range(16), repeat=4):
        found = circles.in_circle(i, j, k, m)
        assert found == in_circle(grid[i], grid[j], grid[k], grid[m])
        if orientation(grid[i], grid[j], grid[k]) != 0:
            assert found == by_centre(grid[i], grid[j], grid[k], grid[m])
        exactly += found == 0
    assert circles.circles_decided_exactly == exactly


@few
@given(st.lists(st.builds(Point, rationals(), rationals()), min_size=4, max_size=5))
def test_the_sign_is_exact_for_nasty_rationals(points: list[Point]) -> None:
    circles = CirclePoints(points)
    for four in permutations(range(len(points)), 4):
        a, b, c, d = (points[i] for i in four)
        found = circles.in_circle(*four)
        assert found == in_circle(a, b, c, d)
        if orientation(a, b, c) != 0:
            assert found == by_centre(a, b, c, d)


@few
@given(st.lists(st.builds(Point, rationals(), rationals()), min_size=4, max_size=4))
def test_exchanging_two_points_turns_the_sign(points: list[Point]) -> None:
    a, b, c, d = points
    sign = in_circle(a, b, c, d)
    assert in_circle(b, c, a, d) == sign and in_circle(b, a, c, d) == -sign and in_circle(a, b, d, c) == -sign


@pytest.mark.parametrize("exponent", [10, 17, 18, 40, 300])
@pytest.mark.parametrize("side", [-1, 0, 1])
def test_points_near_a_circle(exponent: int, side: int) -> None:
    fourth = point(Fraction(-3, 5) * (1 + Fraction(side, 10**exponent)), Fraction(4, 5))
    points = [point(1, 0), point(Fraction(3, 5), Fraction(4, 5)), point(-1, 0), fourth]
    circles = CirclePoints(points)
    assert circles.in_circle(0, 1, 2, 3) == -side
    assert circles.circles_decided_exactly == (side == 0 or exponent > 13)


def test_clusters_and_far_away_points() -> None:
    tiny = mpq(1, 10**60)
    points = [point(0, 0), point(tiny, 0), point(0, tiny), point(tiny / 2, tiny / 3), point(1, 1)]
    circles = CirclePoints(points)
    assert circles.in_circle(0, 1, 2, 3) == 1 and circles.circles_decided_exactly == 1
    far = [Point(p.x * 10**80 + 10**200, p.y * 10**80) for p in points[:4]]
    circles = CirclePoints(far)
    assert circles.in_circle(0, 1, 2, 3) == 1 and circles.circles_decided_exactly == 0


def test_equal_points_and_points_on_a_line_give_zero() -> None:
    a, b, c = point(0, 0), point(3, 1), point(1, 5)
    for four in permutations((a, b, c, a)):
        assert in_circle(*four) == 0
    assert in_circle(point(0, 0), point(1, 2), point(2, 4), point(5, 10)) == 0


def test_the_bound_covers_the_error_of_the_rounded_polynomial() -> None:
    # Coordinates at odd multiples of a quarter of an ulp, where rounding errs most; a small and a large quadruple.
    quarter = mpq(1, 2**54)
    worst = mpq(0)
    corners = [point(-1, -1), point(1, 1)]
    for size in (mpq(1), mpq(1, 2**20)):
        for a, b, c in product((1, 3, 5), repeat=3):
            near = [point(mpq(1, 3) + size * mpq(1, 7) + a * quarter, mpq(2, 5) + b * quarter),
                    point(mpq(1, 3) - c * quarter, mpq(2, 5) + size * mpq(1, 7) - a * quarter),
                    point(mpq(1, 3) - size * mpq(1, 7) + b * quarter, mpq(2, 5) - a * quarter),
                    point(mpq(1, 3) + a * quarter, mpq(2, 5) - size * mpq(1, 7) + c * quarter)]
            xs, ys, scale = unit_floats(corners + near)
            x, y = xs[2:], ys[2:]
            d = [(x[i] - x[3], y[i] - y[3]) for i in range(3)]
            value = mpq(lifted(*d))
            exact = [(p.x - near[3].x, p.y - near[3].y) for p in near[:3]]
            truth = lifted(*exact)
            spread = mpq(sum(abs(px) + abs(py) for px, py in d))
            ratio = abs(value - truth / scale**4) / spread**3 * 2**49
            assert ratio < mpq(7, 10)
            worst = max(worst, ratio)
    assert worst > mpq(1, 10**4)
