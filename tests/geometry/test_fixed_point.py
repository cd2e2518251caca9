"""Fixed-point columns: every sign and order is that of the exact points, whoever decided it."""

import random
from itertools import product

import numpy as np
import pytest
from gmpy2 import mpq

from exactmesh.geometry import fixed_point
from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.fixed_point import FixedPoints, TurnFilter
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import is_ahead, orientation

TINY = mpq(1, 10**25)


def spread(seed: int, count: int) -> list[Point]:
    """Return points on a few lines, some of them off by next to nothing, at very different scales."""
    source = random.Random(seed)
    scale = mpq(10) ** source.choice([-40, 0, 25])
    points = []
    for _ in range(count):
        t = mpq(source.randint(-50, 50), source.choice([1, 2, 3, 7, 1024]))
        off = source.choice([mpq(0), mpq(0), TINY, -TINY, mpq(1, 10**40), mpq(1, 3)])
        slope = source.choice([mpq(0), mpq(1, 3), mpq(-7, 5)])
        points.append(Point(scale * t, scale * (slope * t + off) + source.choice([0, 1]) * scale * TINY))
    return points


@pytest.mark.parametrize("seed", range(12))
def test_orientations_and_directions_are_the_exact_ones(seed: int) -> None:
    points = spread(seed, 60)
    source = np.random.default_rng(seed)
    i, j, k = source.integers(0, len(points), (3, 3000))
    columns = FixedPoints(points)
    single = TurnFilter(columns)
    expected = [orientation(points[a], points[b], points[c]) for a, b, c in zip(i, j, k, strict=True)]
    assert columns.orientations(i, j, k).tolist() == expected
    assert [single.orientation(a, b, c) for a, b, c in zip(i.tolist(), j.tolist(), k.tolist(), strict=True)] == expected
    ahead = [is_ahead(points[a], points[b], points[c]) for a, b, c in zip(i, j, k, strict=True)]
    assert columns.are_ahead(i, j, k).tolist() == ahead
    # Both ways of deciding occur.
    assert 0 < single.third < single.second < single.asked


@pytest.mark.parametrize("seed", range(12))
def test_order_and_coincidence_are_the_exact_ones(seed: int) -> None:
    points = spread(seed, 200)
    columns = FixedPoints(points)
    assert columns.lexicographic().tolist() == sorted(range(len(points)), key=lambda v: (points[v], v))
    first = {p: points.index(p) for p in points}
    expected = [(v, first[p]) for v, p in enumerate(points) if first[p] != v]
    assert columns.coincident() == expected


@pytest.mark.parametrize("size", [1, 2**20, 2**26, 2**60, 10**29])
def test_all_triples_of_a_grid_of_whole_numbers(size: int) -> None:
    points = [Point(mpq(x * size), mpq(y * size)) for x, y in product(range(3), repeat=2)]
    columns = FixedPoints(points)
    i, j, k = np.array(list(product(range(9), repeat=3))).T
    forget()
    found = columns.orientations(i, j, k).tolist()
    assert found == [orientation(points[a], points[b], points[c]) for a, b, c in zip(i, j, k, strict=True)]
    # Small whole numbers are decided by floats alone, zeros included.
    assert columns.error == 0
    assert (decisions()["orientation"].exactly == 0) == (size < 2**26)


def test_the_turn_without_divisors_is_the_orientation() -> None:
    source = random.Random(3)
    for seed in range(20):
        points = spread(seed, 30)
        for _ in range(200):
            a, b, c = source.choices(points, k=3)
            assert fixed_point._turn(a, b, c) == orientation(a, b, c)


def test_a_difference_keeps_its_precision_far_below_a_double() -> None:
    points = [Point(mpq(0), mpq(0)), Point(mpq(1), mpq(1)), Point(mpq(1) + TINY, mpq(1) - TINY / 3)]
    columns = FixedPoints(points)
    x, y = columns.differences(np.array([1]), np.array([2]))
    unit = columns.unit
    for value, exact in ((x[0], TINY), (y[0], -TINY / 3)):
        off = abs(mpq(float(value)) * unit - exact)
        assert off <= exact.__abs__() / mpq(2) ** 53 + columns.error * unit
        assert off < TINY / 10**5


@pytest.mark.parametrize("count", [0, 1, 2])
def test_few_points_or_one_place_are_no_trouble(count: int) -> None:
    points = [Point(mpq(1, 3), mpq(2, 7))] * count
    columns = FixedPoints(points)
    assert columns.lexicographic().tolist() == list(range(count))
    assert columns.coincident() == ([(1, 0)] if count == 2 else [])


def test_long_lists_are_converted_in_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    points = spread(5, 50)
    whole = FixedPoints(points)
    monkeypatch.setattr(fixed_point, "_CHUNK", 7)
    pieces = FixedPoints(points)
    assert (whole.x_high == pieces.x_high).all() and (whole.y_low == pieces.y_low).all()


@pytest.mark.parametrize("size", [1, 7, 2**40, 10**25])
def test_plain_floats_decide_what_is_far_from_a_tie(size: int) -> None:
    source = random.Random(size)
    points = [Point(mpq(source.randrange(size * 1000 + 1)), mpq(source.randrange(size * 1000 + 1))) for _ in range(60)]
    single = TurnFilter(FixedPoints(points))
    triples = [source.sample(range(60), 3) for _ in range(500)]
    assert [single.orientation(*triple) for triple in triples] == [
        orientation(*(points[v] for v in triple)) for triple in triples]
    assert single.second <= 10 and single.third <= 10


@pytest.mark.parametrize("gap", [mpq(1, 7), mpq(1, 2**50), mpq(1, 2**90)])
def test_counting_edges_below_a_point_is_the_orientation_of_each(gap: mpq) -> None:
    # Edges in order from below, nearly parallel; points on them, and barely above and below them.
    ends = [(Point(mpq(0), i * gap), Point(mpq(9), i * gap + mpq(1, 3))) for i in range(9)]
    edges = list(range(9))
    for shift in (-gap / 2**30, mpq(0), gap / 2**30, gap / 2):
        points = [p for pair in ends for p in pair] + [Point(mpq(5), i * gap + mpq(5, 27) + shift) for i in edges]
        single = TurnFilter(FixedPoints(points))
        left, right = list(range(0, 18, 2)), list(range(1, 18, 2))
        for v in range(18, 27):
            expected = sum(orientation(points[left[e]], points[right[e]], points[v]) > 0 for e in edges)
            assert single.count_below(edges, left, right, v) == expected
