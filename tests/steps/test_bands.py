"""Merged regions: bands are tiled and measured exactly, and take the place of thin trapezoids where they are better."""

import random
from dataclasses import replace
from fractions import Fraction

import pytest
from constructions import face_feature_squared, point, unit_shape, untiled
from families import comb, ring
from gmpy2 import mpq

from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import construct
from exactmesh.steps.balance import (
    COARSE,
    COARSE_DEGRADATION,
    COARSE_GAP,
    COARSE_LEVEL_EDGE,
    COARSE_SEPARATION,
    COARSE_THICKNESS_MAX,
    REPAIRED,
    Balance,
)
from exactmesh.steps.bands import Ground, triangulate_band
from exactmesh.steps.constants import GAP
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.offset import offset
from exactmesh.steps.patch_check import check_feature, check_interior_tiling
from exactmesh.steps.trapezoidation import trapezoidate

LEVEL = COARSE.level


def band(seed: int) -> list[tuple[Fraction, int]]:
    """Return a polygon between two chains from left to right on levels, the upper one three or more levels higher."""
    source = random.Random(seed)

    def chain(low: int, high: int) -> list[tuple[Fraction, int]]:
        x, found = Fraction(0), []
        for _ in range(source.randint(2, 12)):
            found.append((x, source.randint(low, high)))
            x += Fraction(source.choice((25, 30, 100, 1000)), 100)
        return found

    below, above = chain(-1, 0), chain(3, 4)
    end = max(below[-1][0], above[-1][0]) + 1
    return [*below, (end, 0), (end, 3), *reversed(above)]


def ground_of(corners: list[tuple[Fraction, int]], edges_at: dict[int, set[int]]) -> Ground:
    return Ground([point(x, y * Fraction(int(LEVEL.numerator), int(LEVEL.denominator))) for x, y in corners], edges_at,
                  LEVEL, COARSE.feature_squared)


@pytest.mark.parametrize("seed", range(12))
def test_a_band_is_tiled_and_measured(seed: int) -> None:
    corners = band(seed)
    ground = ground_of(corners, {})
    found = triangulate_band(ground, range(len(corners)))
    assert found is not None and not found.feet
    points = [*ground.points, *found.new]
    assert untiled(points, range(len(corners)), found.faces) == []
    # T-vertices of one face may be near each other: that is left to the rules that place them.
    assert found.value >= min(face_feature_squared(points, face) for face in found.faces)
    assert bool(found.narrow) == (found.value < COARSE.feature_squared)


def test_feet_are_put_on_edges_of_q_only() -> None:
    # Many vertices a level above a long empty side: too thin for anything else.
    corners = [(Fraction(0), 0), (Fraction(30), 0), *((Fraction(x), 1) for x in range(30, -1, -1))]
    free = triangulate_band(ground_of(corners, {}), range(len(corners)))
    assert free is not None and not free.feet and free.value < COARSE.feature_squared
    assert free.narrow == ((0, 1),)
    ground = ground_of(corners, {0: {7}, 1: {7, 8}})
    found = triangulate_band(ground, range(len(corners)))
    assert found is not None and found.value >= COARSE.feature_squared and {edge for edge, _ in found.feet} == {7}
    points = [*ground.points, *found.new]
    feet = sorted((v for _, v in found.feet), key=lambda v: points[v].x)
    assert len(feet) > 20 and all(points[v].y == 0 for v in feet)
    assert untiled(points, [0, *feet, *range(1, len(corners))], found.faces) == []


def thin_room() -> Pslg:
    """Return a room with ten teeth whose tips are a level above an empty chord: one that begins at a ledge."""
    corners = [(0, 0), (60, 0), (60, 5)]
    for i in range(10):
        x = 50 - 4 * i
        corners += [(x + 1, 5), (x, 2), (x - 1, 5)]
    ledge = Fraction(2) - Fraction(1446, 10000)
    return ring([*corners, (2, 5), (2, ledge), (0, ledge)])


@pytest.mark.parametrize("pslg", [thin_room(), comb(12, floor=400)], ids=["room", "comb"])
def test_merging_is_what_makes_thin_trapezoids_good(pslg: Pslg) -> None:
    shape = unit_shape(pslg)
    q = offset(shape, COARSE)
    chords = trapezoidate(q)
    before = [*shape.points, *q.points, *chords.points]
    plain = triangulate_interior(q, chords, before, balance=replace(COARSE, merges=False))
    merged = triangulate_interior(q, chords, before, balance=COARSE)
    for patch in (plain, merged):
        assert check_interior_tiling(q, chords, patch, [*before, *patch.points]).holds
    least = [check_feature(patch, [*before, *patch.points]).worst for patch in (plain, merged)]
    assert least[1] >= COARSE.feature_squared
    assert (merged.faces != plain.faces) == (least[0] < COARSE.feature_squared)
    used = {v for face in merged.faces for v in face}
    assert used >= set(range(merged.first, merged.first + len(merged.points)))


def test_the_thin_room_is_thin() -> None:
    shape = unit_shape(thin_room())
    q = offset(shape, COARSE)
    chords = trapezoidate(q)
    before = [*shape.points, *q.points, *chords.points]
    plain = triangulate_interior(q, chords, before, balance=replace(COARSE, merges=False))
    assert check_feature(plain, [*before, *plain.points]).worst < COARSE.feature_squared


@pytest.mark.parametrize("balance", [REPAIRED, COARSE], ids=["repaired", "coarse"])
def test_the_body_contains_the_disc_and_the_corridor_has_room(balance: Balance) -> None:
    a, b, g, t = balance.flat, balance.wide, balance.level, balance.crown * balance.level
    # The line through (b, 0) and (a, t) is at distance t or more from the centre.
    assert b**2 * t**2 >= t**2 * (t**2 + (b - a) ** 2)
    assert t == 5 * balance.feature or balance is REPAIRED
    reach_squared = a**2 + (t + g) ** 2
    assert reach_squared >= b**2 + g**2
    separation = COARSE_SEPARATION if balance is COARSE else mpq(599, 10000)
    assert reach_squared <= ((1 - separation) / 2) ** 2
    # A clean trapezoid one level high, with legs that far apart: g F / (g + F) >= f.
    assert g * separation >= balance.feature * (g + separation)


def test_the_bounds_that_the_checkers_assert_follow_from_the_balance() -> None:
    a, g = COARSE.flat, COARSE.level
    reach_squared = a**2 + 9 * g**2
    assert reach_squared <= COARSE_THICKNESS_MAX**2
    assert (1 - COARSE_THICKNESS_MAX) ** 2 - 9 * g**2 >= (COARSE_GAP + a) ** 2 and GAP < COARSE_GAP <= 2 * a
    body_squared = a**2 + (5 * g / 2) ** 2
    length = COARSE_LEVEL_EDGE**2 + g**2
    # length <= (1 - 2 sqrt(body_squared))^2
    assert 4 * body_squared <= 1 and (1 + 4 * body_squared - length) ** 2 >= 16 * body_squared
    assert 1 / COARSE.feature < COARSE_DEGRADATION


def test_the_usual_balance_is_the_default() -> None:
    pslg = thin_room()
    nearest = minimum_feature_size(pslg)
    assert nearest is not None
    subdivision = domain_of(pslg)
    assert construct(subdivision, nearest.squared) == construct(subdivision, nearest.squared, balance=REPAIRED)
