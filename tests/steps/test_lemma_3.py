"""Lemma 3's figure: every set of positions up to nine columns, exactly; where its literal teeth fall short."""

from fractions import Fraction
from functools import partial
from itertools import pairwise

import pytest
from constructions import face_feature_squared, untiled
from gmpy2 import mpq
from unit_rectangles import HEIGHTS, subsets, tube_of

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.steps import lemma_3_check
from exactmesh.steps.lemma_3 import triangulate_rectangle

MIDPOINT = partial(triangulate_rectangle, teeth="midpoint")
RETILED = partial(triangulate_rectangle, teeth="retiled")


def least(tube, points):
    return min(face_feature_squared(points, face) for face in tube.patch.faces)


@pytest.mark.parametrize("fill", [MIDPOINT, RETILED], ids=["midpoint", "retiled"])
@pytest.mark.parametrize("height", HEIGHTS)
def test_every_set_of_positions_is_tiled_without_touching_the_boundary(height, fill):
    for positions in subsets(9):
        tube, points = tube_of(positions, height, fill)
        assert lemma_3_check.check_tiling(tube, points).holds, positions
        assert lemma_3_check.check_boundary(tube, points).holds, positions
        assert lemma_3_check.check_positions(tube, points).holds
        assert lemma_3_check.check_fan(tube, points).holds, positions
        assert lemma_3_check.check_constant(tube, points).holds, positions
        assert lemma_3_check.check_count(tube, points, occupied=False).holds, positions


@pytest.mark.parametrize("height", HEIGHTS)
def test_retiled_teeth_keep_the_stated_bound_and_attain_it(height):
    worst = [lemma_3_check.check_feature(*tube_of(positions, height, RETILED)).worst for positions in subsets(9)]
    assert min(worst) == 1


@pytest.mark.parametrize("height", HEIGHTS)
def test_teeth_over_the_middles_keep_the_corrected_bound(height):
    # w = 1; the supplied right end has a last anchored edge that reaches less than four times as far.
    f1, literal = height**2 / (height**2 + 36), height**2 / (25 * height**2 + 9)
    for positions in subsets(9):
        verdict = lemma_3_check.check_constant(*tube_of(positions, height, MIDPOINT))
        assert verdict.worst * min(height, mpq(1)) ** 2 >= min(f1, literal)


@pytest.mark.parametrize("height", HEIGHTS)
def test_teeth_over_the_middles_break_f2_on_every_full_rectangle_that_has_one(height):
    for columns in range(2, 18):
        tube, points = tube_of(range(columns + 1), height, MIDPOINT)
        assert lemma_3_check.check_teeth(tube, points).holds == (columns == 2)
        assert lemma_3_check.check_teeth(*tube_of(range(columns + 1), height, RETILED)).holds


def test_three_doublings_by_hand():
    # C26: w = 1, h = 2; g_2 stands on 4, its middle is nearer to the first tooth on e_3 than f1, and f1 < f2.
    tube, points = tube_of(range(10), mpq(2), MIDPOINT)
    (box,) = lemma_3_check.boxes(tube, points)
    assert (box.f1_squared(), box.f2_squared()) == (mpq(1, 10), mpq(4, 25))
    assert least(tube, points) == mpq(16, 261)
    t_vertex, foot, tip = Point(mpq(4), mpq(2, 3)), Point(mpq(4), mpq(0)), Point(mpq(9, 2), mpq(5, 4))
    assert segment_distance_squared(t_vertex, foot, tip) == mpq(16, 261)
    assert {t_vertex, foot, tip} < set(points)
    verdict = lemma_3_check.check_feature(tube, points)
    assert not verdict.holds and verdict.worst == mpq(160, 261)
    assert {t_vertex, foot, tip} < {points[v] for v in verdict.witness.place["face"]}


@pytest.mark.parametrize("doublings", range(2, 8))
def test_doublings_approach_the_literal_bound_from_above(doublings):
    # Positions 0 .. 2^k + 1: every anchored edge reaches twice as far as the one before.
    h = mpq(2)
    found = [least(*tube_of(range(2**k + 2), h, MIDPOINT)) for k in (doublings, doublings + 1)]
    assert found[0] > found[1] > h**2 / (16 * h**2 + 9)


def test_a_last_edge_that_reaches_further_goes_below_the_limit_of_doublings():
    h = mpq(2)
    assert h**2 / (25 * h**2 + 9) < least(*tube_of(range(33), h, MIDPOINT)) < h**2 / (16 * h**2 + 9)


@pytest.mark.parametrize("fill", [MIDPOINT, RETILED], ids=["midpoint", "retiled"])
def test_tiling_and_features_agree_with_brute_force(fill):
    for positions in subsets(6):
        tube, points = tube_of(positions, mpq(3, 2), fill)
        (box,) = lemma_3_check.boxes(tube, points)
        assert untiled(points, box.outline, tube.patch.faces) == []
        verdict = lemma_3_check.check_feature(tube, points)
        unit = min(box.f1_squared(), box.f2_squared())
        assert least(tube, points) == Fraction(verdict.worst * unit)


def test_one_vertex_eight_columns_away_takes_more_than_three_new_ones_a_gap():
    over = [positions for positions in subsets(9)
            if not lemma_3_check.check_count(*tube_of(positions, mpq(1), RETILED), occupied=True).holds]
    assert over == [[0, 8, 9]]


def test_one_far_vertex_takes_a_number_of_new_ones_that_grows_with_its_distance():
    counts = [len(triangulate_rectangle([0, 2**k, 2 ** (k + 1)]).steiner) for k in range(1, 40)]
    assert [b - a for a, b in pairwise(counts)] == [2] * 38


@pytest.mark.parametrize("positions", [[], [0], [0, 1], [1, 2, 3], [0, 2, 2, 3], [0, 3, 2], [-1, 0, 1]])
def test_bad_positions_are_refused(positions):
    with pytest.raises(ValueError, match="positions must increase from 0"):
        triangulate_rectangle(positions)
