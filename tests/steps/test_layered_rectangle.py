"""Theorem 2's layers: every set of positions up to nine columns, exactly."""

import pytest
from constructions import untiled
from gmpy2 import mpq
from unit_rectangles import HEIGHTS, subsets, tube_of

from exactmesh.steps import lemma_3_check
from exactmesh.steps.layered_rectangle import triangulate_in_layers


@pytest.mark.parametrize("height", HEIGHTS)
def test_every_set_of_positions_is_properly_tiled_and_keeps_the_bound(height):
    for positions in subsets(9):
        tube, points = tube_of(positions, height, triangulate_in_layers)
        for check in (lemma_3_check.check_tiling, lemma_3_check.check_boundary, lemma_3_check.check_layers_feature,
                      lemma_3_check.check_layer_count):
            assert check(tube, points).holds, positions
        assert lemma_3_check.check_proper(tube).holds


@pytest.mark.parametrize("columns", [2, 3, 4, 5, 8, 9, 31, 32, 33, 64, 128])
def test_full_rectangles_have_as_many_rows_as_halvings(columns):
    tube, points = tube_of(range(columns + 1), mpq(1), triangulate_in_layers)
    verdict = lemma_3_check.check_layer_count(tube, points)
    assert verdict.holds and verdict.worst == 1
    assert len({p.y for p in points} - {mpq(1)}) == (columns - 1).bit_length()
    assert lemma_3_check.check_layers_feature(tube, points).holds


def test_tiling_agrees_with_brute_force():
    for positions in subsets(6):
        tube, points = tube_of(positions, mpq(3, 2), triangulate_in_layers)
        (box,) = lemma_3_check.boxes(tube, points)
        assert untiled(points, box.outline, tube.patch.faces) == []


def test_no_more_new_vertices_than_old_ones():
    for positions in subsets(9):
        assert len(triangulate_in_layers(positions).steiner) < len(positions)


@pytest.mark.parametrize("positions", [[], [0], [0, 1], [1, 2, 3], [0, 2, 2, 3], [0, 3, 2], [-1, 0, 1]])
def test_bad_positions_are_refused(positions):
    with pytest.raises(ValueError, match="positions must increase from 0"):
        triangulate_in_layers(positions)
