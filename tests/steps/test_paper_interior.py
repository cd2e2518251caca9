"""P6 to the letter: a triangulation with one vertex a trapezoid, whose degradation grows without bound."""

import families
import oracle
import pytest
from constructions import cycle_area
from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.steps.paper_interior_check import check_degradation, check_feature, check_tiling

NAMES = sorted(families.ALL_SMALL)


def made(name):
    return Run(families.ALL_SMALL[name], "paper").paper


@pytest.mark.parametrize("name", NAMES)
def test_every_result_passes_its_checker(name):
    done = made(name)
    verdict = check_tiling(done.p4, done.trapezoidation, done.interior, done.points)
    assert verdict.holds and verdict.instances == len(done.interior.faces)
    whole = [z for z in done.trapezoidation.trapezoids if z.bl != z.br and z.tl != z.tr]
    assert len(done.interior.points) == len(whole)
    assert len(done.interior.faces) == 3 * len(whole) + len(done.trapezoidation.trapezoids)
    assert check_feature(done.trapezoidation, done.interior, done.points, done.p4.spacing, done.mfs_squared,
                         clean_only=True).holds


@pytest.mark.parametrize("name", NAMES)
def test_areas_add_up(name):
    done = made(name)
    areas = [cycle_area(done.points, face) for face in done.interior.faces]
    assert min(areas) > 0 and sum(areas) == oracle.polygon_area(done.p4.points)


def test_a_rectangle_by_hand():
    # P4 is the square from (1/4, 2/7) to (3/4, 16/21): the lines 3 and 8 of the grid 2/21.
    done = made("unit square")
    assert done.interior.points == ((mpq(1, 2), mpq(11, 21)),)
    assert {tuple(sorted(face)) for face in done.interior.faces} == {(4, 5, 8), (5, 6, 8), (6, 7, 8), (4, 7, 8)}


GROWTH = {44: mpq(3338329, 1225), 96: mpq(16088521, 1225), 192: mpq(64690249, 1225)}
"""Squared degradations of the whole mesh of the L-shaped hexagon: 52.2, 114.6 and 229.8."""


def test_the_degradation_grows_with_the_spread():
    found = {}
    for length in GROWTH:
        run = Run(families.l_shape(length), "paper")
        assert run.verification.valid
        found[length] = run.verification.degradation_squared
    assert found == GROWTH
    assert list(found.values()) == sorted(set(found.values())) and min(found.values()) > 45**2


def test_p6_alone_loses_ever_more_of_p5():
    worst = []
    for length in (10, 44, 96, 192, 1000):
        done = Run(families.l_shape(length), "paper").paper
        verdict = check_degradation(done.p4, done.trapezoidation, done.interior, done.points)
        worst.append(verdict.worst)
        # Twice the length costs about a factor of two; 8.8 = 192/21.9.
        assert verdict.worst < (mpq(10, length)) ** 2
    assert worst == sorted(set(worst), reverse=True)
    assert worst[1:4] == [mpq(540225, 13353316), mpq(540225, 64354084), mpq(540225, 258760996)]


def test_p5_without_t_vertices_loses_at_most_half():
    clean = [done for done in map(made, NAMES) if not any(z.top or z.bottom for z in done.trapezoidation.trapezoids)]
    assert len(clean) > 8
    for done in clean:
        assert check_degradation(done.p4, done.trapezoidation, done.interior, done.points).holds


def test_a_convex_polygon_can_lose_more():
    # Snapping puts a third vertex on the lowest edge of this P4, a T-vertex of the trapezoid above it.
    done = made("40-gon")
    verdict = check_degradation(done.p4, done.trapezoidation, done.interior, done.points)
    assert not verdict.holds and verdict.worst == mpq(1270071442508087296, 5193259823550758345)
