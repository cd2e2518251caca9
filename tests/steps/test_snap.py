"""Snapping P3 to a grid: ties by hand, the definition by brute force, and its laws."""

from dataclasses import replace
from fractions import Fraction
from itertools import chain

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.paper import simple_polygon
from exactmesh.steps.snap import grid_spacing, snap

few = settings(max_examples=25, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(4, 12), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
spacings = st.fractions(Fraction(1, 50), 2, max_denominator=60).map(lambda f: mpq(f.numerator, f.denominator))
SQUARE = families.ring([(0, 0), (4, 0), (4, 4), (0, 4)])


def snapped(pslg, spacing, ties="up"):
    run = Run(pslg, "paper")
    return run.curve, snap(simple_polygon(run.subdivision), run.curve, mpq(spacing), ties)


@pytest.mark.parametrize("spacing, ties, levels", [
    (1, "up", [1, 1, 3, 3]), (1, "down", [1, 1, 3, 3]),
    # The vertices are at 1 and 3: halfway between multiples of 2.
    (2, "up", [1, 1, 2, 2]), (2, "down", [0, 0, 1, 1]),
    (mpq(3, 2), "up", [1, 1, 2, 2]), (mpq(3, 2), "down", [1, 1, 2, 2]),
    (3, "up", [0, 0, 1, 1]), (7, "down", [0, 0, 0, 0]),
])
def test_levels_by_hand(spacing, ties, levels):
    _, p4 = snapped(SQUARE, spacing, ties)
    assert list(p4.level) == levels and p4.spacing == spacing and p4.shift == 0
    assert p4.points == tuple(Point(mpq(x), mpq(j * spacing)) for x, j in zip((1, 3, 3, 1), levels, strict=True))
    assert p4.rings == ((0, 4),) and p4.first == 4 and p4.x == (1, 3, 3, 1)


def test_ties_below_zero():
    low = families.translated(SQUARE, 0, -4)
    assert snapped(low, 2, "up")[1].level == (-1, -1, 0, 0)
    assert snapped(low, 2, "down")[1].level == (-2, -2, -1, -1)


@few
@given(polygons, spacings, st.sampled_from(["up", "down"]))
def test_no_line_is_nearer_and_x_hardly_moves(pslg, spacing, ties):
    curve, p4 = snapped(pslg, spacing, ties)
    vertices = [v for corner in chain.from_iterable(curve.rings) for v in corner.vertices]
    assert len(vertices) == len(p4.points)
    for v, p, j in zip(vertices, p4.points, p4.level, strict=True):
        distance = abs(v.y - j * spacing)
        assert p.y == j * spacing and all(distance <= abs(v.y - i * spacing) for i in (j - 1, j + 1))
        if ties == "up":
            assert v.y - j * spacing < spacing / 2
        moved = p.x - v.x
        assert moved * moved * 2**34 <= curve.mfs_squared


@few
@given(polygons, spacings, st.integers(-40, 40))
def test_a_shift_by_whole_steps_shifts_the_lines(pslg, spacing, n):
    _, p4 = snapped(pslg, spacing)
    _, moved = snapped(families.translated(pslg, 0, n * spacing), spacing)
    assert moved.level == tuple(j + n for j in p4.level) and moved.x == p4.x


@few
@given(polygons, spacings)
def test_upside_down_the_other_ties(pslg, spacing):
    _, p4 = snapped(pslg, spacing, "up")
    _, turned = snapped(families.moved_by(pslg, lambda p: (-p.x, -p.y), "half a turn"), spacing, "down")
    assert sorted(turned.level) == sorted(-j for j in p4.level)


def test_the_last_vertex_of_a_corner_starts_its_offset_edge():
    curve, p4 = snapped(families.l_shape(4), mpq(1, 10))
    corners = [c.corner for c in chain.from_iterable(curve.rings) for _ in c.vertices]
    assert list(p4.corner) == corners and len(corners) == 8
    assert [s for s in p4.source if s >= 0] == [c.corner for c in chain.from_iterable(curve.rings)]
    assert p4.source.count(-1) == 2


@pytest.mark.parametrize("spacing", [0, -1])
def test_a_spacing_that_is_not_positive_is_refused(spacing):
    with pytest.raises(ValueError, match=f"not {spacing}"):
        snapped(SQUARE, spacing)


@given(st.fractions(Fraction(1, 10**12), 10**12))
@settings(max_examples=100, deadline=None, derandomize=True)
def test_the_grid_is_just_below_the_granularity(m):
    squared, granularity = mpq(m.numerator, m.denominator), mpq(2, 21)
    spacing = grid_spacing(squared, granularity)
    exact = granularity * granularity * squared
    assert spacing * spacing <= exact < (spacing * (1 + mpq(1, 10**9))) ** 2


def test_nothing_that_came_in_is_changed():
    run = Run(SQUARE, "paper")
    before = replace(run.curve)
    snap(simple_polygon(run.subdivision), run.curve, mpq(1))
    assert run.curve == before
