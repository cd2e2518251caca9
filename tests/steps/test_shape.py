"""Bringing a PSLG into units of its mfs: exact, and the same shape at every dyadic scale."""

from fractions import Fraction

import families
import pytest
from constructions import HALL, graph, unit_shape
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.shape import shape_of
from exactmesh.steps.shape_check import check_unit

SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])
TRIANGLE = graph([(0, 0), (8, 0), (0, 8)])
squares = st.fractions(min_value=Fraction(1, 10**12), max_value=10**12).map(mpq)


def test_a_square_in_units_of_its_side():
    shape = shape_of(domain_of(SQUARE), mpq(16))
    assert shape.unit == 4
    assert shape.points == ((0, 0), (1, 0), (1, 1), (0, 1))
    assert shape.origin == (0, 1, 1, 2, 2, 3, 3, 0)
    assert shape.faces == (((0, 2, 4, 6),),) and shape.isolated == ((),) and shape.triangles == ()
    assert shape.corner_count == 4


def test_a_bare_triangle_is_set_aside():
    shape = unit_shape(TRIANGLE)
    assert shape.faces == () and shape.isolated == () and shape.triangles == ((0, 1, 2),)
    assert shape.corner_count == 3


def test_a_clockwise_triangle_is_set_aside_counter_clockwise():
    (triangle,) = unit_shape(families.reversed_orientation(TRIANGLE)).triangles
    a, b, c = (families.reversed_orientation(TRIANGLE).vertices[v] for v in triangle)
    assert (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x)


@pytest.mark.parametrize("extra, edges, walks, isolated", [
    ([(1, 1)], [], 1, (3,)),
    ([(1, 1), (2, 1)], [(3, 4)], 2, ()),
    ([(1, 1), (2, 1), (1, 2)], [(3, 4), (4, 5), (5, 3)], 2, ()),
    ([(1, 1)], [(0, 3)], 1, ()),
])
def test_a_triangle_with_anything_inside_is_not_bare(extra, edges, walks, isolated):
    pslg = graph([*((p.x, p.y) for p in TRIANGLE.vertices), *extra], [*TRIANGLE.edges, *edges])
    shape = unit_shape(pslg)
    meshed = [face for face in shape.faces if len(face) == walks]
    assert len(meshed) == 1 and isolated in shape.isolated


def test_holes_are_left_out():
    face = families.ring([(0, 0), (9, 0), (9, 9), (0, 9)])
    hole = Pslg(face.vertices + tuple(graph([(3, 3), (6, 3), (6, 6), (3, 6)]).vertices),
                (*face.edges, (4, 5), (5, 6), (6, 7), (7, 4)), graph([(4, 4), (5, 4), (5, 5)]).vertices[:1])
    assert len(unit_shape(hole).faces) == 1
    assert len(unit_shape(Pslg(hole.vertices, hole.edges)).faces) == 2


def test_a_dangling_edge_counts_on_both_sides():
    # Seven corners of the room, four of the hole's ring less one, two of the slit, two isolated vertices, and three
    # of the dangling edge: its free end and a second corner where it starts.
    assert unit_shape(HALL).corner_count == 7 + 3 + 2 + 2 + 2


@settings(max_examples=200, derandomize=True, deadline=None)
@given(squares)
def test_the_unit_is_a_short_dyadic_just_below_the_root(squared):
    unit = shape_of(domain_of(SQUARE), squared).unit
    assert unit**2 <= squared < unit**2 * (1 + mpq(1, 2**23)) ** 2
    assert unit.numerator.bit_length() <= 24
    assert bin(unit.denominator).count("1") == 1


@settings(max_examples=100, derandomize=True, deadline=None)
@given(squares, st.integers(-40, 40))
def test_a_power_of_two_changes_the_unit_and_nothing_else(squared, k):
    factor = mpq(2) ** k
    shape = shape_of(domain_of(SQUARE), squared)
    scaled = shape_of(domain_of(families.scaled(SQUARE, factor)), squared * factor**2)
    assert scaled.unit == factor * shape.unit and scaled.points == shape.points


@settings(max_examples=100, derandomize=True, deadline=None)
@given(squares)
def test_every_result_passes_its_checker(squared):
    verdict = check_unit(SQUARE, squared, shape_of(domain_of(SQUARE), squared))
    assert verdict.holds and verdict.instances == 1 and 1 <= verdict.worst < (1 + mpq(1, 2**23)) ** 2
