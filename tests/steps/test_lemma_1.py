"""Lemma 1's vertex against brute force: all trapezoids on a small grid, and the lemma's symmetries."""

from fractions import Fraction
from itertools import product

import oracle
import pytest
from gmpy2 import mpq

from exactmesh.steps.lemma_1 import lemma_1_abscissa

HEIGHTS = (Fraction(1, 3), 1, 2, 7)
SHAPES = list(product(range(1, 5), range(-5, 6), range(1, 5)))
"""Widths of the bottom, abscissae of the top's left end, widths of the top; the bottom starts at 0."""
SIDES = [(0, 1), (1, 2), (2, 3), (3, 0)]
SPOKES = [(i, 4) for i in range(4)]


def abscissa(bottom, start, top):
    return lemma_1_abscissa(mpq(0), mpq(bottom), mpq(start), mpq(start + top))


def corners(bottom, start, top, height):
    return [(0, 0), (bottom, 0), (start + top, height), (start, height)]


def left_of_feature(bottom, start, top, height):
    """Return how much of the squared mfs of the trapezoid is left with the vertex, by brute force."""
    shape = corners(bottom, start, top, height)
    s = (oracle.exact(abscissa(bottom, start, top)), Fraction(height, 2))
    return oracle.mfs_squared([*shape, s], SIDES + SPOKES) / oracle.mfs_squared(shape, SIDES)


@pytest.mark.parametrize("height", HEIGHTS)
def test_half_of_the_feature_size_is_left_in_every_trapezoid_of_the_grid(height):
    left = [left_of_feature(*shape, height) for shape in SHAPES]
    assert min(left) == Fraction(1, 4) and max(left) <= 1


def test_the_lemma_is_tight_in_both_cases():
    assert left_of_feature(2, -1, 4, 1) == Fraction(1, 4)       # case 1, h < l
    assert left_of_feature(2, 3, 2, 1) == Fraction(1, 4)        # case 2


def test_the_vertex_is_strictly_inside():
    for bottom, start, top in SHAPES:
        x = abscissa(bottom, start, top)
        assert mpq(start, 2) < x < mpq(bottom + start + top, 2)


def test_mirror_images_have_mirrored_vertices():
    for bottom, start, top in SHAPES:
        mirrored = lemma_1_abscissa(mpq(-bottom), mpq(0), mpq(-start - top), mpq(-start))
        assert mirrored == -abscissa(bottom, start, top)


def test_turning_a_trapezoid_upside_down_keeps_the_abscissa():
    for bottom, start, top in SHAPES:
        assert lemma_1_abscissa(mpq(start), mpq(start + top), mpq(0), mpq(bottom)) == abscissa(bottom, start, top)


def test_moving_and_scaling_go_through():
    for bottom, start, top in SHAPES:
        moved = lemma_1_abscissa(*(mpq(7, 3) * x - 5 for x in (0, bottom, start, start + top)))
        assert moved == mpq(7, 3) * abscissa(bottom, start, top) - 5


@pytest.mark.parametrize("shape, x", [
    ((4, 0, 4), 2),                   # a rectangle: its centre
    ((2, -3, 9), 1),                  # the bottom fits: its middle
    ((9, 2, 4), 4),                   # the top fits: its middle
    ((2, 3, 2), mpq(5, 2)),           # a parallelogram: its centre
    ((2, 3, 7), mpq(5, 2)),           # leaning right: the parallelogram along the left leg
    ((2, -9, 7), -1),                 # leaning left: along the right leg
])
def test_by_hand(shape, x):
    assert abscissa(*shape) == x
