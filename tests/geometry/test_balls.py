"""Balls: every one contains the number that it stands for, and nothing is decided against exact arithmetic."""

import random

import numpy as np
import pytest
from gmpy2 import mpq

from exactmesh.geometry.balls import Balls, ball_of, constant, exact_balls, greatest, joined, least, where
from exactmesh.geometry.decisions import Count, decisions, forget, note


def numbers(seed, count=200, spread=30):
    source = random.Random(seed)
    return [mpq(source.randint(-10**12, 10**12), source.randint(1, 10**9)) * mpq(2) ** source.randint(-spread, spread)
            for _ in range(count)]


def near(values, seed):
    """Return values a hair beside others."""
    source = random.Random(seed)
    return [v * (1 + mpq(source.randint(-9, 9), 2**source.randint(45, 60))) for v in values]


def assert_contained(balls, values):
    for mid, rad, low, high, value in zip(balls.mid.tolist(), balls.rad.tolist(), balls.low().tolist(),
                                          balls.high().tolist(), values, strict=True):
        if np.isfinite(rad):
            assert abs(value - mpq(mid)) <= mpq(rad) * (1 + mpq(1, 2**40))
            assert mpq(low) <= value <= mpq(high)


@pytest.mark.parametrize("seed", range(5))
def test_every_operation_contains_the_exact_result(seed):
    a = numbers(seed)
    for b in (numbers(seed + 100), near(a, seed)):
        p, q = ball_of(*a), ball_of(*b)
        assert_contained(p, a)
        assert_contained(-p, [-x for x in a])
        assert_contained(p + q, [x + y for x, y in zip(a, b, strict=True)])
        assert_contained(p - q, [x - y for x, y in zip(a, b, strict=True)])
        assert_contained(p * q, [x * y for x, y in zip(a, b, strict=True)])
        assert_contained(p / (q - p), [x / (y - x) if x != y else 0 for x, y in zip(a, b, strict=True)])
        assert_contained((p - q).squared(), [(x - y) ** 2 for x, y in zip(a, b, strict=True)])
        assert_contained((p - q).sizes(), [abs(x - y) for x, y in zip(a, b, strict=True)])
        assert_contained(least(p, q, p - q), [min(x, y, x - y) for x, y in zip(a, b, strict=True)])
        assert_contained(greatest(p, q), [max(x, y) for x, y in zip(a, b, strict=True)])


@pytest.mark.parametrize("seed", range(5))
def test_long_expressions_are_contained(seed):
    a, b, c = numbers(seed), near(numbers(seed), seed), near(numbers(seed), seed + 1)
    p, q, r = ball_of(*a), ball_of(*b), ball_of(*c)
    values, balls = a, p
    for _ in range(30):
        balls = (balls - q) * (r - p) + q
        values = [(v - y) * (z - x) + y for v, x, y, z in zip(values, a, b, c, strict=True)]
        assert_contained(balls, values)


@pytest.mark.parametrize("seed", range(5))
def test_sums_are_contained(seed):
    values = numbers(seed)
    start = np.array([0, 1, 7, 100])
    ends = [1, 7, 100, len(values)]
    assert_contained(ball_of(*values).sums(start),
                     [sum(values[i:j], mpq(0)) for i, j in zip(start.tolist(), ends, strict=True)])


@pytest.mark.parametrize("seed", range(5))
def test_signs_are_right_or_open(seed):
    a = numbers(seed)
    b = [x if i % 3 else y for i, (x, y) in enumerate(zip(a, near(a, seed), strict=True))]
    signs = (ball_of(*a) - ball_of(*b)).signs().tolist()
    for x, y, sign in zip(a, b, signs, strict=True):
        assert sign in (0, (x > y) - (x < y))
    assert (ball_of(*a) - ball_of(*[-x for x in a])).signs().all()


def test_what_does_not_fit_decides_nothing():
    huge, tiny = mpq(10) ** 400, mpq(1, 10**400)
    for value in (huge, -huge):
        assert ball_of(value).signs().tolist() == [0]
    assert ball_of(tiny).signs().tolist() == [0]
    far = ball_of(mpq(10) ** 300)
    for balls in (far * far, far.squared() - far.squared(), exact_balls([1.0]) / exact_balls([0.0])):
        assert balls.signs().tolist() == [0] and not balls.low()[0] > 0 and not balls.high()[0] < 0


def test_products_that_underflow_are_contained():
    small = mpq(3, 2**600)
    assert_contained(ball_of(small) * ball_of(small), [small * small])
    assert (ball_of(small) * ball_of(small)).signs().tolist() == [0]


def test_plain_numbers_are_exact():
    some = exact_balls([1.5, -2.0])
    assert some.rad.tolist() == [0, 0] and constant(0.0, some).mid.tolist() == [0, 0]
    assert isinstance(some[np.array([True, False])], Balls) and len(some[:1]) == 1


def test_balls_are_put_one_after_the_other_and_chosen():
    p, q = ball_of(mpq(1, 3), mpq(2)), ball_of(mpq(5))
    both = joined(p, q)
    assert both.mid.tolist() == [*p.mid.tolist(), *q.mid.tolist()]
    assert both.rad.tolist() == [*p.rad.tolist(), *q.rad.tolist()]
    wide = Balls(np.array([7.0, 8.0]), np.array([1.0, 2.0]))
    chosen = where(np.array([True, False]), p, wide)
    assert chosen.mid.tolist() == [p.mid[0], 8.0] and chosen.rad.tolist() == [p.rad[0], 2.0]


def test_whole_numbers_become_floats():
    some = exact_balls([1, 2])
    assert some.mid.dtype == some.rad.dtype == np.float64
    assert (some / exact_balls([3, 7])).mid.dtype == np.float64


def test_what_is_noted_adds_up():
    forget()
    note("b", 7, 2)
    note("a", 1, 1)
    note("b", 5, 4)
    assert decisions() == {"a": Count(0, 1), "b": Count(6, 6)} and list(decisions()) == ["a", "b"]
    forget()
    assert decisions() == {}
