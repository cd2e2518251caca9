"""Proposals on floats: where a star's centre may lie, pockets without new vertices, points of few bits."""

import random
from itertools import pairwise
from math import cos, pi, sin, sqrt

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.geometry.point import Point
from exactmesh.optimize.faces import Faces
from exactmesh.optimize.local import Local
from exactmesh.optimize.place import Spot, best_places, height, middle_of, places
from exactmesh.optimize.pockets import best_triangles

SQUARE = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]


def least(ring: list[Spot], centre: Spot) -> float:
    return min(height(u, v, centre) for u, v in pairwise([*ring, ring[0]]))


@st.composite
def rings(draw: st.DrawFn) -> list[Spot]:
    """Star-shaped rings around the origin."""
    count = draw(st.integers(3, 9))
    source = random.Random(draw(st.integers(0, 10**6)))
    turns = sorted(source.random() for _ in range(count))
    return [(r * cos(2 * pi * t), r * sin(2 * pi * t)) for t in turns for r in (source.uniform(0.5, 3),)]


@given(rings(), st.floats(0.01, 1), st.integers(0, 10**6))
def test_the_places_are_those_where_every_triangle_of_the_fan_is_high_enough(
        ring: list[Spot], size: float, seed: int) -> None:
    region = places(ring, size)
    source = random.Random(seed)
    for x, y in region:
        assert least(ring, (x, y)) >= size - 1e-7
    for _ in range(200):
        spot = source.uniform(-3, 3), source.uniform(-3, 3)
        if least(ring, spot) >= size + 1e-7:
            assert region
            corners = zip(region, [*region[1:], region[0]], strict=True)
            assert all((c - a) * (spot[1] - b) - (d - b) * (spot[0] - a) >= -1e-7 for (a, b), (c, d) in corners)


@given(rings())
def test_the_best_place_is_no_worse_than_those_of_a_grid(ring: list[Spot]) -> None:
    size, region = best_places(ring, 0.0, 10.0)
    best = max(least(ring, (i / 8, j / 8)) for i in range(-24, 25) for j in range(-24, 25))
    assert size >= best - 10 / 2**6
    if region:
        assert least(ring, middle_of(region)) >= size - 1e-7


def test_the_best_place_in_a_square_is_its_middle_and_more_than_there_is_has_none() -> None:
    # Each triangle of the fan has height 1 on the side, and more than 1 otherwise.
    size, region = best_places(SQUARE, 0.5, 4.0)
    assert size == pytest.approx(1, abs=0.05) and middle_of(region) == pytest.approx((1, 1), abs=0.1)
    assert best_places(SQUARE, 1.01, 4.0) == (1.01, [])
    assert best_places(SQUARE, 0.1, 0.5)[0] == 0.5


def test_heights_are_signed_and_least() -> None:
    assert height((0, 0), (4, 0), (0, 3)) == pytest.approx(12 / 5)
    assert height((0, 0), (0, 3), (4, 0)) == pytest.approx(-12 / 5)
    assert height((1, 1), (1, 1), (1, 1)) == 0


def test_a_pocket_is_triangulated_as_well_as_can_be() -> None:
    # A flat hexagon: of its 14 triangulations the best has no triangle on three vertices of one long side.
    ring = [(0.0, 0.0), (2.0, -0.3), (4.0, 0.0), (4.0, 2.0), (2.0, 2.3), (0.0, 2.0)]
    value, triangles = best_triangles(ring, 0.0, 10.0)
    assert len(triangles) == 4 and value == pytest.approx(min(height(*(ring[i] for i in t)) for t in triangles))
    assert value == pytest.approx(max(_all_values(ring, tuple(range(6)))))
    assert best_triangles(ring, value, 10.0) == (value, [])
    assert best_triangles(ring, 0.0, value / 2)[0] == value / 2


def _all_values(ring: list[Spot], part: tuple[int, ...]) -> list[float]:
    """Return the least heights of all triangulations of a part of a ring."""
    if len(part) < 3:
        return [10.0]
    i, *inner, j = part
    return [min(height(ring[i], ring[k], ring[j]), a, b) for at, k in enumerate(inner, 1)
            for a in _all_values(ring, part[: at + 1]) for b in _all_values(ring, part[at:])]


@given(st.integers(-50, 50), st.integers(-50, 50), st.fractions(min_value="1/1000", max_value=9))
def test_a_simple_point_lies_inside_and_has_few_bits(x: int, y: int, size: object) -> None:
    origin = Point(mpq(x, 7), mpq(y, 9))
    faces = Faces([origin, Point(origin.x + 1, origin.y), Point(origin.x, origin.y + 1)], 3, set(), [(0, 1, 2)])
    width = float(mpq(size))
    region = [(0.0, 0.0), (width, 0.0), (width, width), (0.0, width)]
    point = Local(faces, 0).simple_point(region)
    assert point is not None
    assert 0 <= point.x - origin.x <= mpq(width) and 0 <= point.y - origin.y <= mpq(width)
    # The next coarser grid but one need not have a point in the square.
    assert mpq(1) / max(point.x.denominator, point.y.denominator) >= min(mpq(width) / 4, 1)


def test_a_strip_around_a_simple_line_gives_a_point_on_the_line() -> None:
    faces = Faces([Point(mpq(0), mpq(0)), Point(mpq(1), mpq(0)), Point(mpq(0), mpq(1))], 3, set(), [(0, 1, 2)])
    strip = [(0.1, 0.4999999), (5.3, 0.4999999), (5.3, 0.5000001), (0.1, 0.5000001)]
    point = Local(faces, 0).simple_point(strip)
    assert point is not None and point.y == mpq(1, 2)
    thin = [(0.1, sqrt(2) / 3 - 1e-16), (0.1 + 1e-16, sqrt(2) / 3 - 1e-16), (0.1 + 1e-16, sqrt(2) / 3)]
    assert Local(faces, 0).simple_point(thin) is None


def test_places_beyond_the_doubles_are_no_error() -> None:
    far = mpq(10) ** 400
    faces = Faces([Point(mpq(0), mpq(0)), Point(far, mpq(0)), Point(mpq(0), far)], 3, set(), [(0, 1, 2)])
    local = Local(faces, 0)
    ring = [local[0], local[1], local[2]]
    size, region = best_places(ring, 0.5, 1.0)
    assert not region or local.simple_point(region) is None
    assert size in (0.5, 1.0)
