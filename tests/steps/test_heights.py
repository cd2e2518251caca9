"""Heights and feature sizes of single triangles, against the definition with fractions."""

from fractions import Fraction

import oracle
import pytest
from constructions import point
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.geometry.point import Point
from exactmesh.steps.heights import feature_squared, height_squared

numbers = st.fractions(min_value=-20, max_value=20, max_denominator=9)
points = st.builds(point, numbers, numbers)
laws = settings(max_examples=150, derandomize=True, deadline=None)


def least_height_squared(a, b, c):
    """Return the least squared distance of a corner from the line of the opposite side."""
    found = []
    for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
        (px, py), (qx, qy), (rx, ry) = map(oracle.place, (p, q, r))
        area = (qx - px) * (ry - py) - (qy - py) * (rx - px)
        found.append(area**2 / ((rx - qx) ** 2 + (ry - qy) ** 2))
    return min(found)


def test_a_right_triangle():
    assert height_squared(point(0, 0), point(4, 0), point(0, 3)) == mpq(144, 25)


@pytest.mark.parametrize("c, sign", [((1, 2), 1), ((1, -2), -1), ((5, 0), 0), ((0, 0), 0)])
def test_the_sign_tells_the_turn(c, sign):
    value = height_squared(point(0, 0), point(2, 0), point(*c))
    assert (value > 0) - (value < 0) == sign


@laws
@given(points, points, points)
def test_the_height_is_the_least_distance_of_a_corner_from_the_opposite_line(a, b, c):
    value = height_squared(a, b, c)
    turn = oracle.turn(*map(oracle.triple, (a, b, c)))
    if turn == 0:
        assert value == 0
    else:
        assert value == turn * least_height_squared(a, b, c)
        assert height_squared(b, c, a) == value == -height_squared(a, c, b)


@laws
@given(points, points, points, st.tuples(*[st.sets(st.integers(1, 9), max_size=3)] * 3))
def test_the_feature_size_is_that_of_the_definition(a, b, c, places):
    if height_squared(a, b, c) <= 0:
        assert feature_squared((a, b, c), ([], [], [])) == height_squared(a, b, c)
        return
    ends = ((a, b), (b, c), (c, a))
    sides = tuple([Point(p.x + (q.x - p.x) * mpq(k, 10), p.y + (q.y - p.y) * mpq(k, 10)) for k in sorted(on)]
                  for (p, q), on in zip(ends, places, strict=True))
    value = feature_squared((a, b, c), sides)
    cycle = [a, *sides[0], b, *sides[1], c, *sides[2]]
    # Neighbours on one side are left to the rules that place them; here only the two other sides count.
    by_hand = [least_height_squared(a, b, c)]
    for i, on in enumerate(sides):
        others = [ends[(i + 1) % 3], ends[(i + 2) % 3]]
        by_hand += [oracle.mfs_squared([t, p, q], [(1, 2)]) for t in on for p, q in others]
    # `mfs_squared` also sees the side itself, which is no shorter than the least height.
    assert value == min(by_hand)
    assert value >= oracle.mfs_squared(cycle, [(i - 1, i) for i in range(1, len(cycle))] + [(len(cycle) - 1, 0)])


@laws
@given(points, points, points, st.fractions(min_value=Fraction(1, 9), max_value=9))
def test_scaling_scales_the_square(a, b, c, factor):
    factor = mpq(factor)
    scaled = [Point(p.x * factor, p.y * factor) for p in (a, b, c)]
    assert height_squared(*scaled) == factor**2 * height_squared(a, b, c)
