"""The checker of the change of units accepts good results and names the clause a harmed one breaks."""

from dataclasses import replace

import pytest
from constructions import clauses_of, graph, run
from gmpy2 import mpq
from recorded import recorded

from exactmesh.geometry.point import Point
from exactmesh.planar.faces import domain_of
from exactmesh.steps import shape_check
from exactmesh.steps.shape import shape_of
from exactmesh.steps.shape_check import check_unit

FAMILIES = ["hall", "triangle", "tiny", "huge", "30 digits", "turned pslg", "convex spike 1e-6"]
PSLG = graph([(0, 0), (7, 1), (6, 8), (-1, "17/3")])
SQUARED = mpq(30)
SHAPE = shape_of(domain_of(PSLG), SQUARED)


def moved(shape, v, dx, dy):
    points = list(shape.points)
    points[v] = Point(points[v].x + mpq(dx), points[v].y + mpq(dy))
    return replace(shape, points=tuple(points))


def in_unit(factor):
    """Return a harm that divides by another unit, points and all."""
    def harm(shape):
        points = tuple(Point(p.x / mpq(factor), p.y / mpq(factor)) for p in shape.points)
        return replace(shape, unit=shape.unit * mpq(factor), points=points)
    return harm


HARMS = [
    ("a vertex moved in x", lambda s: moved(s, 2, "1/1000000000000", 0), "points are the input's in units of m"),
    ("a vertex moved in y", lambda s: moved(s, 0, 0, -1), "points are the input's in units of m"),
    ("two vertices exchanged", lambda s: replace(s, points=(s.points[1], s.points[0], *s.points[2:])),
     "points are the input's in units of m"),
    ("the unit alone", lambda s: replace(s, unit=s.unit * (1 - mpq(1, 10**9))),
     "points are the input's in units of m"),
    ("a unit above the mfs", in_unit("1000001/1000000"), "m <= mfs"),
    ("a unit of twice the mfs", in_unit(2), "m <= mfs"),
    ("a unit too far below the mfs", in_unit("999998/1000000"), "mfs <= (1 + 1e-6) m"),
    ("half the unit", in_unit("1/2"), "mfs <= (1 + 1e-6) m"),
]


@pytest.mark.parametrize("name", FAMILIES)
def test_good_results_are_accepted(name):
    made = run(name)
    verdict = check_unit(made.subdivision.pslg, made.mfs.squared, made.construction.shape)
    assert verdict.holds and verdict.instances == 1


@pytest.mark.parametrize("what, harm, clause", HARMS, ids=[what for what, _, _ in HARMS])
def test_harmed_results_are_refused(what, harm, clause):
    verdict = check_unit(PSLG, SQUARED, harm(SHAPE))
    assert not verdict.holds and verdict.witness.clause == clause


def test_the_bounds_themselves_are_allowed():
    exact = in_unit(1 / SHAPE.unit)(SHAPE)
    assert check_unit(PSLG, mpq(1), exact).holds
    assert check_unit(PSLG, mpq(1000001, 1000000) ** 2, exact).holds
    assert not check_unit(PSLG, mpq(1000001, 1000000) ** 2 + mpq(1, 10**40), exact).holds
    assert not check_unit(PSLG, 1 - mpq(1, 10**40), exact).holds


def test_every_clause_fires():
    assert {clause for _, _, clause in HARMS} == clauses_of(shape_check)


def test_verdicts_say_all_there_is_to_say():
    with recorded("shape", shape_check) as lines:
        lines += [("good", check_unit(PSLG, SQUARED, SHAPE)),
                        *((what, check_unit(PSLG, SQUARED, harm(SHAPE))) for what, harm, _ in HARMS)]


def test_as_many_points_as_vertices_are_needed():
    with pytest.raises(ValueError):
        check_unit(PSLG, SQUARED, replace(SHAPE, points=SHAPE.points[:-1]))
